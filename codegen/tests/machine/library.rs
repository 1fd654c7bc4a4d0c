//! The shader library on the machine.

use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;
use terrane_codegen::machine::{Machine, NoTextures};

#[test]
fn every_function_of_the_library_can_be_evaluated() {
    let library = Library::load(&mut Sources::default(), &[]).expect("the shipped library is right");
    let machine = Machine::new(&library.module, &library.info, &NoTextures);
    let functions = library.module.functions.iter().filter_map(|(_, function)| function.name.as_deref());
    let wrong: Vec<String> =
        functions.filter_map(|name| machine.supports(name).err()).map(|error| error.to_string()).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
