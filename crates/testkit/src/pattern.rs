//! Whether the pattern of a kind is that of an Assur group.

use assur_group::Pattern;

/// Greatest number of links whose subsets are all looked at.
const MOST_LINKS: usize = 16;

/// Whether a pattern is that of an Assur group: it has no mobility, and no part of it is determined without the rest.
///
/// # Errors
///
/// What is wrong, in words.
pub(crate) fn is_assur_group(pattern: &Pattern) -> Result<(), String> {
    let count = pattern.links;
    let inner = pattern.inner.iter().flat_map(|(ends, _)| *ends);
    let mut named = inner.chain(pattern.outer.iter().map(|(link, _)| *link));
    if let Some(link) = named.find(|&link| link >= count) {
        return Err(match count {
            0 => "the pattern has no links".to_owned(),
            _ => format!("the pattern names link {link}; it has 0 to {}", count - 1),
        });
    }
    if let Some(([link, _], _)) = pattern.inner.iter().find(|([a, b], _)| a == b) {
        return Err(format!("the pattern joins link {link} to itself"));
    }
    if count == 0 || !count.is_multiple_of(2) {
        return Err(format!("a group has 2, 4, 6 ... links, the pattern has {count}"));
    }
    let pairs = pattern.inner.len() + pattern.outer.len();
    if 2 * pairs != 3 * count {
        return Err(format!("{count} links need {} pairs, the pattern has {pairs}", 3 * count / 2));
    }
    if count > MOST_LINKS {
        return Ok(());
    }
    let all = (1_usize << count) - 1;
    // Small parts first, so that the one named has no such part itself.
    let mut parts: Vec<usize> = (1..all).collect();
    parts.sort_by_key(|part| part.count_ones());
    match parts.into_iter().find(|&part| mobility(pattern, part) <= 0) {
        Some(part) => {
            let links = words(&(0..count).filter(|link| part >> link & 1 == 1).collect::<Vec<_>>());
            Err(match mobility(pattern, part) {
                0 => format!("the pattern is no Assur group: {links} are a group of their own"),
                _ if part.is_power_of_two() => {
                    format!("the pattern is no Assur group: {links} has more outer pairs than it needs")
                }
                _ => format!("the pattern is no Assur group: {links} have more pairs than they need"),
            })
        }
        None => Ok(()),
    }
}

/// Mobility of some links (the bits of `part`) where all bodies outside the group stand still and the other links of
/// the group are left out.
fn mobility(pattern: &Pattern, part: usize) -> i64 {
    let has = |link: usize| part >> link & 1 == 1;
    let inner = pattern.inner.iter().filter(|([a, b], _)| has(*a) && has(*b)).map(|_| 2);
    let outer = pattern.outer.iter().filter(|(link, _)| has(*link)).map(|_| 2);
    3 * i64::from(part.count_ones()) - inner.chain(outer).sum::<i64>()
}

/// `links 0, 1 and 4`.
fn words(links: &[usize]) -> String {
    let names: Vec<_> = links.iter().map(usize::to_string).collect();
    match names.split_last() {
        Some((last, [])) => format!("link {last}"),
        Some((last, before)) => format!("links {} and {last}", before.join(", ")),
        None => String::new(),
    }
}
