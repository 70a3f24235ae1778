//! However many jobs are asked for, few are performed, the newest among them.

use std::path::PathBuf;
use std::sync::mpsc::channel;
use std::sync::{Arc, Barrier};

use super::Workers;
use crate::screen::state::{Job, Report, Source, Wanted};

fn read(number: usize) -> Job {
    Job::Read(Wanted::Compare(Source::File(PathBuf::from(format!("none-{number}.toml"))), 1))
}

fn number(report: &Report) -> String {
    match report {
        Report::Read(Wanted::Compare(source, _), Err(_)) => source.name(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn of_a_thousand_jobs_the_first_and_the_newest_are_performed() {
    let (sender, reports) = channel();
    let gate = Arc::new(Barrier::new(2));
    let passed = Arc::clone(&gate);
    let workers = Workers::new(move |report| {
        // The first job ends when all others were asked for.
        if number(&report).contains("none-0.") {
            passed.wait();
        }
        sender.send(report).unwrap();
    });
    (0..1000).for_each(|number| workers.start(read(number)));
    gate.wait();
    let all = [(); 2].map(|()| number(&reports.recv().unwrap()));
    assert!(all[0].contains("none-0.") && all[1].contains("none-999."), "{all:?}");
    // Whether more would come is known when the kind is free again.
    while !super::lock(&workers.busy).is_empty() {
        std::thread::yield_now();
    }
    assert!(reports.try_recv().is_err());
    workers.start(read(7));
    assert!(number(&reports.recv().unwrap()).contains("none-7."));
}
