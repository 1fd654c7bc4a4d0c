//! Evaluates naga IR on the CPU, generic over the number domain.
