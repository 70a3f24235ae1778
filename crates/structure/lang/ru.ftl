structure-group = группа { $number } ({ $kind } { $links })
    .short = группа { $number }
structure-links-named = { $count ->
        [one] звено
       *[other] звенья
    } { $links }
structure-pairs = { $count ->
        [one] пара
       *[other] пары
    } { $pairs }
structure-some = { $names } ... (показано { $shown } из { $total })
structure-loose = степень подвижности { $mobility } ({ $formula }), а механизм движет один вход: { $links } { $count ->
        [one] может
       *[other] могут
    } двигаться при неподвижном входе{ $also }; присоедините { $count ->
        [one] его
       *[other] их
    } к другому звену ещё одной парой или уберите то, что там не закреплено ({ $hint })
structure-loose-also = {" "}(в то же время пары { $pairs } имеют одну лишнюю связь)
structure-more-inputs = у механизма { $mobility } степени свободы ({ $formula }), поэтому входов ему нужно { $mobility }, а есть { $inputs }. При неподвижных входах { $links } ещё могут двигаться: задайте остальные записями `[[input]]` или отнимите эти степени ещё одной парой или звеном меньше
structure-dependent-input = вход `{ $input }`: то, что он движет, уже определяют входы перед ним; степеней свободы { $mobility } ({ $formula }), входов { $inputs }. Уберите этот вход или приведите другую пару
structure-surplus = степень подвижности { $mobility } ({ $formula }), а должна быть { $inputs }: { $pairs } { $count ->
        [one] даёт
       *[other] дают
    } одну лишнюю связь; там { $links }; уберите оттуда одну пару или одно звено ({ structure-what-joins }: точки, которые не шарниры, должны иметь свои имена){ $block }{ $cause }
structure-missing-block = ; если палец должен двигаться вдоль паза звена `{ $on }`, то недостаёт его камня: отдельного звена, которое соединено шарниром со звеном `{ $link }`{ $at } и скользит по `{ $on }`
structure-at-point = {" "}в точке `{ $point }`
structure-no-plugin = { $links } образуют группу класса { $class }, порядка { $order } ({ $pattern }); для неё не зарегистрирован плагин (см. `assur plugins`; другое входное звено может дать другие группы)
structure-pattern = внутренние { $inner }; внешние { $outer }
structure-what-joins = имя точки, употреблённое в двух звеньях, образует там шарнир
structure-alike = точки `{ $one }` и `{ $other }` есть каждая лишь в одном звене, и имена их похожи: одинаковое имя в обоих звеньях образует шарнир
structure-slide-angles = угол пары `{ $slide }` расходится на { $off } с тем, чего требуют другие направляющие, и ни одно положение не подходит всем; звену, ось x которого не лежит вдоль направляющей, нужен `tilt`, здесь `tilt = "{ $tilt }"`
structure-slide-on-pinned = в поступательной паре `{ $slide }` двигаться нечему: те же два звена соединяет шарнир `{ $pin }`
structure-alone = имя точки, употреблённое в двух звеньях, образует там шарнир; только в одном звене есть точки { $points }
structure-passive-link = звено «{ $link }»
structure-passive-pair = пара { $pair } звена «{ $link }»
