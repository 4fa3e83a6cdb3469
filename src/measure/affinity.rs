//! Which processors the calling thread may run on: what the system offers of it, in plain numbers.

#[cfg(target_os = "linux")]
mod system {
    use nix::sched::{CpuSet, sched_getaffinity, sched_setaffinity};
    use nix::unistd::Pid;
    use std::sync::OnceLock;

    /// Where the process was let run before it chose a processor itself.
    static BEFORE: OnceLock<Vec<usize>> = OnceLock::new();

    /// The calling thread, as these two calls name it.
    const THIS_THREAD: Pid = Pid::from_raw(0);

    /// Numbers of the processors that the calling thread may run on, ascending.
    ///
    /// # Errors
    /// Why the system does not tell.
    pub fn allowed_cpus() -> Result<Vec<usize>, String> {
        let set = sched_getaffinity(THIS_THREAD).map_err(|error| error.to_string())?;
        Ok((0..CpuSet::count()).filter(|&cpu| set.is_set(cpu) == Ok(true)).collect())
    }

    /// Keeps the calling thread, and those that it starts from now on, on these processors.
    ///
    /// # Errors
    /// Why the system refuses.
    pub fn run_on(cpus: &[usize]) -> Result<(), String> {
        if let Ok(allowed) = allowed_cpus() {
            BEFORE.get_or_init(|| allowed);
        }
        let mut set = CpuSet::new();
        cpus.iter()
            .try_for_each(|&cpu| set.set(cpu))
            .and_then(|()| sched_setaffinity(THIS_THREAD, &set))
            .map_err(|error| error.to_string())
    }

    /// Lets the calling thread run wherever the process could at its start, whatever processor was
    /// chosen for measuring since. For work without a clock.
    pub fn run_anywhere() {
        // Where the system refuses, the thread stays where it is, and is only slower.
        if let Some(cpus) = BEFORE.get() {
            run_on(cpus).ok();
        }
    }

    /// How many processors [`run_anywhere`] lets a thread use.
    pub fn anywhere() -> usize {
        let now = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        BEFORE.get().map_or_else(now, Vec::len)
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    const LINUX_ONLY: &str = "a processor is chosen on Linux only";

    /// Nothing is known here.
    ///
    /// # Errors
    /// Always.
    pub fn allowed_cpus() -> Result<Vec<usize>, String> {
        Err(LINUX_ONLY.to_owned())
    }

    /// Nothing is done here.
    ///
    /// # Errors
    /// Always.
    pub fn run_on(_cpus: &[usize]) -> Result<(), String> {
        Err(LINUX_ONLY.to_owned())
    }

    /// Nothing to be done here.
    pub fn run_anywhere() {}

    /// How many processors there are.
    pub fn anywhere() -> usize {
        std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
    }
}

pub(super) use system::run_on;
pub use system::{allowed_cpus, anywhere, run_anywhere};

/// The processors that a measuring thread may move between: those that it may run on, or none where
/// the system does not tell, and where some are slower by design (Linux lists the two kinds of hybrid
/// processors so).
pub fn alike_cpus() -> Vec<usize> {
    if std::path::Path::new("/sys/devices/cpu_atom").exists() {
        return Vec::new();
    }
    allowed_cpus().unwrap_or_default()
}

/// The numbers as the system writes them, such as `0-3,8`; they ascend.
pub(super) fn list_of(cpus: &[usize]) -> String {
    let runs = cpus.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
        [first, .., last] => format!("{first}-{last}"),
        [only] => only.to_string(),
        [] => String::new(),
    });
    runs.collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_short() {
        assert_eq!(list_of(&[0, 1, 2, 3, 8]), "0-3,8");
        assert_eq!(list_of(&[1, 3]), "1,3");
        assert_eq!(list_of(&[]), "");
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_thread_stays_where_it_is_put() {
        // In a thread of its own: the setting dies with it.
        let check = || {
            let allowed = allowed_cpus().expect("Linux tells");
            let last = *allowed.last().expect("it runs somewhere");
            run_on(&[last]).expect("that one is allowed");
            assert_eq!(allowed_cpus(), Ok(vec![last]));
            // What a thread inherits, it may leave.
            let heir = std::thread::spawn(|| (allowed_cpus(), run_anywhere(), allowed_cpus()));
            let (inherited, (), left) = heir.join().expect("nothing in it fails");
            assert_eq!(inherited, Ok(vec![last]));
            assert_eq!(left.map(|cpus| cpus.len()), Ok(anywhere()));
            run_on(&allowed).expect("all are allowed");
            assert_eq!(allowed_cpus(), Ok(allowed));
            assert!(run_on(&[usize::MAX]).is_err());
        };
        std::thread::spawn(check).join().expect("no assertion fails");
    }
}
