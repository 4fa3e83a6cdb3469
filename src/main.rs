//! `ray_test`: parse, run the verb, print the error chain, exit code.

use std::process::ExitCode;

fn main() -> ExitCode {
    ray_test::cli::main()
}
