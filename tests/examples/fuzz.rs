//! The long fuzz run: `cargo run --release -p assur-tests --example fuzz -- FROM COUNT FOLDER`; with `variants` at the end, of
//! variants of the shipped scenes instead.
//!
//! Inputs are run in a child process, which ends itself when one of them takes too long; then another child goes on with the
//! next. Every input of which something was found, or a check of which fails, is written to the folder, with what was found as
//! its first line, and the counts are printed at the end.

use std::collections::BTreeMap;
use std::error::Error;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use assur_tests::fuzz::{Outcome, input, known, run, variant};

/// An input that takes more time of the processors hangs: six times as long as anything may take.
const LONGEST: Duration = Duration::from_mins(1);

/// The word that asks for variants of the shipped scenes.
const VARIANTS: &str = "variants";

/// What may become of an input: the names of [`assur_tests::fuzz::Outcome`].
const OUTCOMES: [&str; 5] = ["Refused", "Unsolved", "Stopped", "Solved", "CheckFailed"];

/// What makes the inputs: where one comes from, and its text.
type Maker = Box<dyn Fn(u64) -> (String, String)>;

fn maker(variants: bool) -> Result<Maker, Box<dyn Error>> {
    if variants {
        return Ok(Box::new(|number| ("Variant".to_owned(), variant(number))));
    }
    let known = known()?;
    Ok(Box::new(move |number| {
        let (source, text) = input(number, &known);
        (format!("{source:?}"), text)
    }))
}

/// The time of the processors that this process took; where the system does not tell, the time since `start`.
fn processor_time(start: Instant) -> Duration {
    /// Hundredths of a second, in the user's code and in the system: the fields after the state of the process.
    const FIELDS: std::ops::Range<usize> = 11..13;
    let told = std::fs::read_to_string("/proc/self/stat").ok();
    let ticks = told.as_deref().and_then(|told| {
        let (_, fields) = told.rsplit_once(')')?;
        let times = fields.split_whitespace().skip(FIELDS.start).take(FIELDS.len());
        times.map(|field| field.parse::<u64>().ok()).sum::<Option<u64>>()
    });
    ticks.map_or_else(|| start.elapsed(), |ticks| Duration::from_millis(10 * ticks))
}

/// Runs inputs and prints a line for each: its number and what became of it.
fn child(from: u64, end: u64, input: &Maker) {
    std::panic::set_hook(Box::new(|_| {}));
    let start = Instant::now();
    let now = Arc::new(Mutex::new((from, Duration::ZERO)));
    let watched = Arc::clone(&now);
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(Duration::from_millis(200));
            let Ok(now) = watched.lock() else { continue };
            if processor_time(start).saturating_sub(now.1) > LONGEST {
                println!("{}\thang\tmore than {} s", now.0, LONGEST.as_secs());
                std::process::exit(3);
            }
        }
    });
    for number in from..end {
        if let Ok(mut now) = now.lock() {
            *now = (number, processor_time(start));
        }
        let (source, text) = input(number);
        let (what, detail) = match run(&text) {
            Ok(Outcome::CheckFailed(detail)) => ("CheckFailed".to_owned(), detail),
            Ok(outcome) => (format!("{outcome:?}"), source),
            Err(finding) => (finding.what.to_owned(), finding.detail.escape_debug().to_string()),
        };
        println!("{number}\t{what}\t{detail}");
    }
}

fn parent([from, count]: [u64; 2], folder: &Path, kind: &str) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(folder)?;
    let input = maker(kind == VARIANTS)?;
    let mut counts: BTreeMap<String, u64> = BTreeMap::new();
    let (mut next, end) = (from, from + count);
    while next < end {
        let arguments = ["child".to_owned(), next.to_string(), end.to_string(), kind.to_owned()];
        let mut child = Command::new(std::env::current_exe()?)
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()?;
        let mut hangs = false;
        for line in BufReader::new(child.stdout.take().ok_or("no output")?).lines() {
            let line = line?;
            let mut parts = line.splitn(3, '\t');
            let number: u64 = parts.next().unwrap_or_default().parse()?;
            let (what, detail) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
            hangs = what == "hang";
            *counts.entry(what.to_owned()).or_default() += 1;
            if !OUTCOMES.contains(&what) || what == "CheckFailed" {
                let text = format!("# {what}: {detail}\n{}", input(number).1);
                std::fs::write(folder.join(format!("{number}.toml")), text)?;
            }
            next = number + 1;
        }
        if !child.wait()?.success() && !hangs && next < end {
            *counts.entry("abort".to_owned()).or_default() += 1;
            std::fs::write(folder.join(format!("{next}.toml")), format!("# abort\n{}", input(next).1))?;
            next += 1;
        }
    }
    for (what, count) in &counts {
        println!("{count:>9}  {what}");
    }
    let findings: u64 =
        counts.iter().filter(|(what, _)| !OUTCOMES.contains(&what.as_str())).map(|(_, count)| count).sum();
    if findings > 0 {
        return Err(format!("{findings} findings, kept in {}", folder.display()).into());
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match &arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["child", from, end, kind] => {
            child(from.parse()?, end.parse()?, &maker(*kind == VARIANTS)?);
            Ok(())
        }
        [from, count, folder] => parent([from.parse()?, count.parse()?], Path::new(folder), ""),
        [from, count, folder, VARIANTS] => {
            parent([from.parse()?, count.parse()?], Path::new(folder), VARIANTS)
        }
        ["write", from, count, folder] => {
            let from: u64 = from.parse()?;
            std::fs::create_dir_all(folder)?;
            for number in from..from + count.parse::<u64>()? {
                std::fs::write(Path::new(folder).join(format!("{number}.toml")), variant(number))?;
            }
            Ok(())
        }
        [file] => {
            println!("{:?}", run(&std::fs::read_to_string(file)?)?);
            Ok(())
        }
        _ => Err("usage: fuzz FROM COUNT FOLDER [variants], fuzz write FROM COUNT FOLDER for the texts of variants, or fuzz FILE for one scene".into()),
    }
}
