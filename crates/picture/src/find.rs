//! What is looked for by its name: reactions, plans, quantities, rows of a list.

use assur_analysis::results::Schema;
use assur_book::catalogue;
use assur_words::Text;

use crate::{Look, Picture, Reaction, Results, Series, ViewPart};

impl Look<'_> {
    /// Chooses what a part of a picture shows by its name, the next one behind what is chosen now; `told` makes words of a text.
    ///
    /// # Errors
    ///
    /// What can be found, where nothing has this name: of each all its names, first the one that tells it from the others.
    pub fn choose(
        &mut self,
        results: &Results,
        shown: (Picture, ViewPart),
        sought: &str,
        told: impl Fn(&Text) -> String,
    ) -> Result<(), Vec<Vec<String>>> {
        let names = self.names(results, shown, &told);
        let now = match shown {
            (Picture::Forces, _) => self.reaction,
            (Picture::Plans, ViewPart::Forces) => self.polygon,
            (Picture::Structure, _) => self.group,
            // The first construction of a name.
            (Picture::Plans, _) => names.len().saturating_sub(1),
            _ => self.column,
        };
        let Some(index) = by_name(&names, now, sought) else {
            return Err(names);
        };
        match shown {
            (Picture::Forces, _) => self.reaction = index,
            (Picture::Plans, ViewPart::Forces) => self.polygon = index,
            (Picture::Structure, _) => self.group = index,
            (Picture::Plans, _) => {
                // With all its steps.
                let plans = results.found.as_ref().map(|found| found.plans.at(self.position));
                self.step = plans.and_then(|plans| plans.steps_of(index).last()).unwrap_or_default();
            }
            _ => {
                self.column = index;
                self.transfer = results.transfer_of(index).unwrap_or(self.transfer);
            }
        }
        Ok(())
    }

    /// The names of what a part of a picture can show, each with all of its own: the whole one first, then its parts, as in files.
    fn names(
        &self,
        results: &Results,
        (picture, part): (Picture, ViewPart),
        told: &dyn Fn(&Text) -> String,
    ) -> Vec<Vec<String>> {
        let found = results.found.as_deref();
        let plans = || found.map(|found| found.plans.at(self.position));
        match (picture, part) {
            (Picture::Forces, _) => {
                let series = |index: &usize| found.map(|found| found.series[*index].short.clone());
                let names = |reaction: &Reaction| {
                    let of = reaction.of.iter().flat_map(|(pair, link)| [pair.to_string(), link.to_string()]);
                    let columns = reaction.series.iter().chain(&reaction.moment).filter_map(series);
                    [told(&reaction.name)].into_iter().chain(of).chain(columns).collect()
                };
                found.iter().flat_map(|found| &found.reactions).map(names).collect()
            }
            (Picture::Plans, ViewPart::Construction) => {
                let plans = plans();
                let all = plans.iter().flat_map(|plans| &plans.constructions);
                all.map(|(method, drawn)| vec![(*method).to_owned(), told(&drawn.title)]).collect()
            }
            (Picture::Plans, ViewPart::Forces) => {
                let plans = plans();
                let sheet = plans.as_ref().and_then(|plans| plans.sheet.as_ref().ok());
                let all = sheet.iter().flat_map(|sheet| &sheet.polygons);
                all.map(|polygon| vec![told(&polygon.title)]).collect()
            }
            (Picture::Plans, _) => Vec::new(),
            (Picture::Structure, _) => results.group_names().iter().map(|name| vec![told(name)]).collect(),
            _ => {
                let schema = match found {
                    Some(found) => found.rows().0.schema(),
                    None => &Schema::new(&results.linkage.mechanism),
                };
                let in_files = |series: &Series| catalogue::csv(schema, series.column);
                let names = |series: &Series| {
                    let told = [told(&series.told()), told(&series.of), told(&series.head)];
                    told.into_iter().chain([series.short.clone()]).chain(in_files(series)).collect()
                };
                results.columns().map(names).collect()
            }
        }
    }
}

/// The first of so many items that fits, of those after the present one and then of those up to it.
pub fn next(now: usize, count: usize, fits: impl Fn(usize) -> bool) -> Option<usize> {
    (1..=count).map(|step| (now + step) % count).find(|index| fits(*index))
}

/// The next item behind `now` that has just this name, else but for capital letters; else in a name of which it occurs as a word of
/// its own, written alike; else as a word; else anywhere, if it has more than one letter; else in whose names together all its words
/// occur.
pub fn by_name(all: &[Vec<String>], now: usize, sought: &str) -> Option<usize> {
    let lower = sought.to_lowercase();
    let is_word = |name: &str, sought: &str| {
        let mut places = name.match_indices(sought);
        places.any(|(at, _)| {
            let (before, after) = (&name[..at], &name[at + sought.len()..]);
            !before.ends_with(char::is_alphanumeric) && !after.starts_with(char::is_alphanumeric)
        })
    };
    let fits: [&dyn Fn(&str) -> bool; 5] = [
        &|name| name == sought,
        &|name| name.to_lowercase() == lower,
        &|name| is_word(name, sought),
        &|name| is_word(&name.to_lowercase(), &lower),
        &|name| sought.chars().nth(1).is_some() && name.to_lowercase().contains(&lower),
    ];
    let whole =
        fits.iter().find_map(|fits| next(now, all.len(), |item| all[item].iter().any(|name| fits(name))));
    let words: Vec<&str> = lower.split_whitespace().collect();
    let occurs = |names: &[String], word: &str| names.iter().any(|name| name.to_lowercase().contains(word));
    whole.or_else(|| {
        let is_spoken = words.len() > 1;
        is_spoken.then(|| next(now, all.len(), |item| words.iter().all(|word| occurs(&all[item], word))))?
    })
}
