//! The machine: what of it stays the same from run to run, and its name made of that.

use serde::{Deserialize, Serialize};
use std::fs::read_to_string;
use std::path::Path;

/// One cache of the first processor.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Cache {
    /// 1 is nearest to the core.
    pub level: u32,
    /// `Data`, `Instruction` or `Unified`.
    pub kind: String,
    /// Bytes.
    pub size_bytes: u64,
    /// Bytes of a line, where known.
    pub line_bytes: Option<u64>,
}

/// What a test bed is known by. Nothing here changes with load, frequency, name or updates.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Machine {
    /// The processor's name, or the architecture's where it has none.
    pub processor: String,
    /// Vendor, family, model and stepping as the system prints them, where known.
    pub processor_id: Option<String>,
    /// Architecture, such as `x86_64`.
    pub architecture: String,
    /// Operating system, such as `linux`.
    pub system: String,
    /// Processors that the system has online, where known.
    pub logical_cpus: Option<usize>,
    /// Whether it runs under a hypervisor, where known.
    pub hypervisor: Option<bool>,
    /// Caches of the first processor; empty where unknown.
    pub caches: Vec<Cache>,
}

impl Machine {
    /// This machine.
    pub fn this() -> Self {
        let cpuinfo = read_to_string("/proc/cpuinfo").unwrap_or_default();
        let online = read_to_string("/sys/devices/system/cpu/online").ok();
        let counted = || std::thread::available_parallelism().ok().map(usize::from);
        Machine {
            architecture: std::env::consts::ARCH.to_owned(),
            system: std::env::consts::OS.to_owned(),
            logical_cpus: online.and_then(|list| list_length(&list)).or_else(counted),
            caches: caches(Path::new("/sys/devices/system/cpu/cpu0/cache")),
            ..Machine::of_cpuinfo(&cpuinfo)
        }
    }

    /// What the text of `/proc/cpuinfo` tells of the first processor.
    fn of_cpuinfo(text: &str) -> Self {
        let field = |name: &str| {
            let pairs = text.lines().filter_map(|line| line.split_once(':'));
            let mut values = pairs.filter(|(key, _)| key.trim() == name);
            values.next().map(|(_, value)| value.trim()).filter(|value| !value.is_empty())
        };
        let names = [
            ["vendor_id", "cpu family", "model", "stepping"],
            ["CPU implementer", "CPU variant", "CPU part", "CPU revision"],
        ];
        let ids = names.map(|set| set.iter().filter_map(|name| field(name)).collect::<Vec<_>>());
        let id = ids.into_iter().find(|id| !id.is_empty()).map(|id| id.join(" "));
        // Arm lists Features and says nothing of hypervisors there.
        let hypervisor = field("flags").map(|f| f.split_whitespace().any(|f| f == "hypervisor"));
        let processor = field("model name").unwrap_or(std::env::consts::ARCH).to_owned();
        Machine { processor, processor_id: id, hypervisor, ..Machine::default() }
    }

    /// 16 hexadecimal digits, equal for equal machines.
    pub fn testbed_id(&self) -> String {
        format!("{:016x}", fnv1a(format!("{self:?}").as_bytes()))
    }
}

/// FNV-1a with 64 bits: Fowler, Noll, Vo; draft-eastlake-fnv.
pub(super) fn fnv1a(bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

/// How many numbers a list such as `0-3,8` names; `None` if it is no such list.
pub(super) fn list_length(list: &str) -> Option<usize> {
    let mut length: usize = 0;
    for part in list.trim().split(',') {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        let (first, last) = (first.parse::<usize>().ok()?, last.parse::<usize>().ok()?);
        length = length.checked_add(last.checked_sub(first)?.checked_add(1)?)?;
    }
    Some(length)
}

fn caches(folder: &Path) -> Vec<Cache> {
    let cache = |index: u32| {
        let folder = folder.join(format!("index{index}"));
        let text = |name: &str| Some(read_to_string(folder.join(name)).ok()?.trim().to_owned());
        Some(Cache {
            level: text("level")?.parse().ok()?,
            kind: text("type")?,
            size_bytes: size_bytes(&text("size")?)?,
            line_bytes: text("coherency_line_size").and_then(|size| size.parse().ok()),
        })
    };
    (0..16).map_while(cache).collect()
}

/// Bytes of a size such as `48K` or `32M`.
fn size_bytes(text: &str) -> Option<u64> {
    let (number, unit) = match text.strip_suffix('K') {
        Some(number) => (number, 1 << 10),
        None => text.strip_suffix('M').map_or((text, 1), |number| (number, 1 << 20)),
    };
    number.parse::<u64>().ok()?.checked_mul(unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CPUINFO: &str = "processor\t: 0\nvendor_id\t: AuthenticAMD\ncpu family\t: 26\n\
        model\t\t: 2\nmodel name\t: AMD EPYC\nstepping\t: 1\ncpu MHz\t\t: 2600.0\n\
        flags\t\t: fpu sse hypervisor avx512f\n\nprocessor\t: 1\nmodel name\t: other\n";

    #[test]
    fn reads_the_first_processor() {
        let machine = Machine::of_cpuinfo(CPUINFO);
        assert_eq!(machine.processor, "AMD EPYC");
        assert_eq!(machine.processor_id.as_deref(), Some("AuthenticAMD 26 2 1"));
        assert_eq!(machine.hypervisor, Some(true));
        let bare = Machine::of_cpuinfo(&CPUINFO.replace("hypervisor ", ""));
        assert_eq!(bare.hypervisor, Some(false));
    }

    #[test]
    fn reads_processors_of_arm_and_none() {
        let arm = Machine::of_cpuinfo("CPU implementer\t: 0x41\nCPU part\t: 0xd0c\n");
        assert_eq!(arm.processor_id.as_deref(), Some("0x41 0xd0c"));
        assert_eq!((arm.processor.as_str(), arm.hypervisor), (std::env::consts::ARCH, None));
        assert_eq!(Machine::of_cpuinfo("").processor_id, None);
    }

    #[test]
    fn id_follows_the_machine_and_not_its_frequency() {
        let id = |text: &str| Machine::of_cpuinfo(text).testbed_id();
        assert_eq!(id(CPUINFO), id(&CPUINFO.replace("2600.0", "3100.0")));
        assert_ne!(id(CPUINFO), id(&CPUINFO.replace("stepping\t: 1", "stepping\t: 2")));
        assert_eq!(id(CPUINFO).len(), 16);
    }

    #[test]
    fn hash_of_the_published_test_vectors() {
        assert_eq!(fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn lists_and_sizes() {
        assert_eq!(list_length("0-3,8\n"), Some(5));
        assert_eq!(list_length("0"), Some(1));
        assert_eq!((list_length(""), list_length("3-1"), list_length("a")), (None, None, None));
        assert_eq!((size_bytes("48K"), size_bytes("32M")), (Some(49_152), Some(33_554_432)));
        assert_eq!((size_bytes("64"), size_bytes("big")), (Some(64), None));
    }
}
