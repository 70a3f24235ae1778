plugin-twice = под именем `{ $name }` зарегистрированы два плагина ({ $what }): { $first } и { $second }; переименуйте один из них
plugin-ambiguous = два плагина ({ $what }) подходят одинаково: `{ $first }` из { $first_crate } и `{ $second }` из { $second_crate }; уберите один или опишите один из них точнее
plugin-empty = не зарегистрирован ни один плагин ({ $what }); программа должна быть скомпонована с плагинами (`use assur_all as _;`)
plugin-unknown = нет плагина ({ $what }) с именем `{ $name }`; есть: { $known }
