//! A guard of what the program writes: its hashes, kept in a file. It says that something changed, never that it was right.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The variable that renews the hashes; its value says why they changed.
const RENEW: &str = "GUARD";

const HEAD: &str = "\
# Scene, form, hash (FNV-1a, 64 bits) of what the program writes; `-` with the exit status where nothing is written.
# CONTRIBUTING.md, \"Guard\", says how it is renewed; guard-changes.txt says which hash changed since and why.
";

/// Hashes by scene and form.
pub type Hashes = BTreeMap<(String, String), String>;

/// FNV-1a with 64 bits.
#[derive(Debug, Clone, Copy)]
pub struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    /// The digits of the hash of these bytes.
    pub fn of(bytes: &[u8]) -> String {
        let mut hash = Self::default();
        hash.add(bytes);
        hash.digits()
    }

    /// Goes on with these bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// All 16 hexadecimal digits.
    pub fn digits(self) -> String {
        format!("{:016x}", self.0)
    }
}

/// The hash of a JSON text without the strings that are values, and that of these alone.
pub fn numbers_and_texts(json: &[u8]) -> [String; 2] {
    let (mut numbers, mut texts) = (Hash::default(), Hash::default());
    let mut at = 0;
    while at < json.len() {
        let from = at;
        if json[at] == b'"' {
            at += 1;
            while json[at] != b'"' {
                at += if json[at] == b'\\' { 2 } else { 1 };
            }
        }
        at += 1;
        let is_value = json[from] == b'"' && json.get(at) != Some(&b':');
        if is_value { &mut texts } else { &mut numbers }.add(&json[from..at]);
    }
    [numbers.digits(), texts.digits()]
}

/// Names and paths of the scenes in a folder of the checkout.
///
/// # Panics
///
/// If this is not a checkout: the function is for tests.
pub fn scenes(folder: &str) -> Vec<(String, PathBuf)> {
    let files = fs::read_dir(root().join(folder)).expect("this is a checkout");
    let paths = files.filter_map(|entry| Some(entry.ok()?.path()));
    let scenes = paths.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    scenes.filter_map(|path| Some((path.file_stem()?.to_str()?.to_owned(), path))).collect()
}

/// The hashes that all jobs give, by as many threads as the machine runs at once.
///
/// # Panics
///
/// If a job does.
pub fn hashes<J: Sync>(jobs: &[(String, J)], run: impl Fn(&J) -> Vec<(String, String)> + Sync) -> Hashes {
    let (next, found) = (AtomicUsize::new(0), Mutex::new(Hashes::new()));
    let work = || {
        while let Some((scene, job)) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) {
            let own = run(job).into_iter().map(|(form, hash)| ((scene.clone(), form), hash));
            found.lock().expect("no job panicked").extend(own.collect::<Vec<_>>());
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    found.into_inner().expect("no job panicked")
}

/// Compares hashes with those of a file in the folder `tests` of the checkout; with the variable `GUARD`, writes them there,
/// and what changed behind the reason that is its value.
///
/// # Panics
///
/// If a hash differs, with all that do; if a file can't be written.
pub fn compare(file: &str, found: &Hashes) {
    let folder = root().join("tests");
    let file = folder.join(file);
    let before = fs::read_to_string(&file).unwrap_or_default();
    let changes = changes(&kept(&before), found);
    let mut text = HEAD.to_owned();
    for ((scene, form), hash) in found {
        let _ = writeln!(text, "{scene} {form} {hash}");
    }
    let Ok(why) = std::env::var(RENEW) else {
        assert!(before == text, "what is written has changed (CONTRIBUTING.md, Guard): {changes}");
        return;
    };
    fs::write(file, text).expect("the file of hashes can be written");
    if !why.is_empty() && !changes.is_empty() {
        let file = folder.join("guard-changes.txt");
        let before = fs::read_to_string(&file).unwrap_or_default();
        fs::write(file, format!("{before}{why}: {changes}\n")).expect("the file of changes can be written");
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The hashes of a file; of two for one form, as a merge leaves them, the last one.
fn kept(text: &str) -> Hashes {
    let line = |line: &str| match line.split(' ').collect::<Vec<_>>()[..] {
        [scene, form, hash] if !scene.starts_with('#') => {
            Some(((scene.to_owned(), form.to_owned()), hash.to_owned()))
        }
        _ => None,
    };
    text.lines().filter_map(line).collect()
}

/// The forms that differ, each with its scenes.
fn changes(kept: &Hashes, found: &Hashes) -> String {
    let all: BTreeSet<_> = kept.keys().chain(found.keys()).collect();
    let mut changes: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for key in all.into_iter().filter(|key| kept.get(*key) != found.get(*key)) {
        changes.entry(&key.1).or_default().push(&key.0);
    }
    let forms = changes.iter().map(|(form, scenes)| format!("{form} ({})", scenes.join(" ")));
    forms.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::{Hash, numbers_and_texts};

    #[test]
    fn texts_of_json_are_apart_from_its_numbers() {
        let [numbers, texts] = numbers_and_texts(br#"{"a\"b":1.5,"t":"x: \"1\"","l":["y",2]}"#);
        assert_eq!(numbers, Hash::of(br#"{"a\"b":1.5,"t":,"l":[,2]}"#));
        assert_eq!(texts, Hash::of(br#""x: \"1\"""y""#));
        // The published value of FNV-1a of these letters.
        assert_eq!(Hash::of(b"foobar"), "85944171f73967e8");
    }
}
