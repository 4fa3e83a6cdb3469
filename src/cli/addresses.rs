//! Addresses that stay the same from process to process.
//!
//! A branch predictor and the caches index what they keep by address, and the system draws the
//! addresses of a program anew each time it starts. Of one program on one machine, that alone made
//! one cell in ten differ by more than 1 % from run to run, and some by 12 %. With one placement runs agree
//! with each other; how far another placement would be from it is what copies of the reference
//! tell (`noise_floor`), and it is larger between builds than between runs.

use std::process::ExitCode;

/// Bytes of the stack, as many as the first thread usually has.
const STACK: usize = 8 << 20;

/// Does the program's work on a stack that begins at a page. The first thread's begins behind the arguments
/// and the environment: their length alone moved packets by 3 %, since a processor that looks for
/// a store (here of spilled registers) before a load (of a triangle) compares their places within a page.
/// Where there can be no second thread, the first does the work.
pub fn on_own_stack(work: fn() -> ExitCode) -> ExitCode {
    let thread = std::thread::Builder::new().name("ray_test".into()).stack_size(STACK);
    match thread.spawn(work) {
        Ok(handle) => handle.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
        Err(_) => work(),
    }
}

/// Starts the program again with addresses that are not drawn, if the system lets it; otherwise all
/// stays as it is, and the environment of the results says so (`aslr`).
#[cfg(target_os = "linux")]
pub fn settle() {
    use nix::sys::personality::{Persona, get, set};
    use std::os::unix::process::CommandExt;

    let (Ok(persona), Ok(program)) = (get(), std::env::current_exe()) else { return };
    if persona.contains(Persona::ADDR_NO_RANDOMIZE) {
        return;
    }
    if set(persona | Persona::ADDR_NO_RANDOMIZE).is_ok() {
        let mut arguments = std::env::args_os();
        let name = arguments.next().unwrap_or_else(|| program.clone().into());
        // Comes back only if it failed.
        let _error = std::process::Command::new(program).arg0(name).args(arguments).exec();
    }
}

/// Other systems are not asked.
#[cfg(not(target_os = "linux"))]
pub fn settle() {}
