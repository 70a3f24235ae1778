plugin-twice = під назвою `{ $name }` зареєстровано два плагіни ({ $what }): { $first } і { $second }; перейменуйте один із них
plugin-ambiguous = два плагіни ({ $what }) однаково підходять: `{ $first }` із { $first_crate } і `{ $second }` із { $second_crate }; приберіть один або опишіть один із них точніше
plugin-empty = не зареєстровано жодного плагіна ({ $what }); програма має бути скомпонована з плагінами (`use assur_all as _;`)
plugin-unknown = немає плагіна ({ $what }) з назвою `{ $name }`; є: { $known }
