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

/// Where glibc looks for its settings, and the one that gives whatever takes a page or more pages of its
/// own. Smaller things lie where the clock has put them (a longer number is a longer text), and pushed
/// data to other pages; by which a group of packets in registers had one kernel of eighteen that was 1 to
/// 4 % slower, another one in each process (a Zen 4 guesses the way of its first cache by the page).
#[cfg(target_os = "linux")]
const TUNABLES: &str = "GLIBC_TUNABLES";
#[cfg(target_os = "linux")]
const THRESHOLD: &str = "glibc.malloc.mmap_threshold";

/// Starts the program again with addresses that are not drawn, and data on pages of their own, if the
/// system lets it; otherwise all stays as it is, and the environment of the results says so (`aslr`).
#[cfg(target_os = "linux")]
pub fn settle() {
    use nix::sys::personality::{Persona, get, set};
    use std::os::unix::process::CommandExt;

    let (Ok(persona), Ok(program)) = (get(), std::env::current_exe()) else { return };
    let tunables = std::env::var(TUNABLES).unwrap_or_default();
    if persona.contains(Persona::ADDR_NO_RANDOMIZE) && tunables.contains(THRESHOLD) {
        return;
    }
    if set(persona | Persona::ADDR_NO_RANDOMIZE).is_ok() {
        let mut arguments = std::env::args_os();
        let name = arguments.next().unwrap_or_else(|| program.clone().into());
        let mut again = std::process::Command::new(program);
        again.env(TUNABLES, with_threshold(tunables));
        // Comes back only if it failed.
        let _error = again.arg0(name).args(arguments).exec();
    }
}

/// Whoever sets it, knows better.
#[cfg(target_os = "linux")]
fn with_threshold(tunables: String) -> String {
    match tunables.as_str() {
        set if set.contains(THRESHOLD) => tunables,
        "" => format!("{THRESHOLD}=4096"),
        others => format!("{others}:{THRESHOLD}=4096"),
    }
}

/// Other systems are not asked.
#[cfg(not(target_os = "linux"))]
pub fn settle() {}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn other_tunables_stay() {
        let with = |text: &str| with_threshold(text.to_owned());
        assert_eq!(with(""), "glibc.malloc.mmap_threshold=4096");
        assert_eq!(with("glibc.malloc.check=1"), format!("glibc.malloc.check=1:{}", with("")));
        assert_eq!(with("glibc.malloc.mmap_threshold=1"), "glibc.malloc.mmap_threshold=1");
    }
}
