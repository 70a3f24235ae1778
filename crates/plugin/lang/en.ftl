plugin-twice = two plugins are registered as { $what } `{ $name }`: { $first } and { $second }; rename one
plugin-ambiguous = two plugins registered as { $what } fit the same thing: `{ $first }` of { $first_crate } and `{ $second }` of { $second_crate }; leave one out, or declare one more precisely
plugin-empty = no { $what } is registered; the program must link the plugins (`use assur_all as _;`)
plugin-unknown = no { $what } is called `{ $name }`; there are: { $known }
