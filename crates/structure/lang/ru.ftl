structure-group = группа { $number } ({ $kind } { $links })
structure-links-named = { $count ->
        [one] звено
       *[other] звенья
    } { $links }
structure-pairs = { $count ->
        [one] пара
       *[other] пары
    } { $pairs }
structure-some = { $names } ... (показано { $shown } из { $total })
structure-loose = подвижность { $mobility } ({ $formula }), а механизм движет один вход: { $links } { $count ->
        [one] может
       *[other] могут
    } двигаться при неподвижном входе{ $also }; присоедините { $count ->
        [one] его
       *[other] их
    } к другому звену ещё одной парой или уберите то, что там висит ({ $hint })
structure-loose-also = {" "}(в то же время пары { $pairs } имеют одну лишнюю связь)
structure-more-inputs = у механизма { $mobility } степени свободы ({ $formula }), поэтому ему нужно { $mobility } входа; рассчитываются механизмы с одним. При неподвижном входе { $links } ещё могут двигаться: ещё одна пара или на звено меньше оставили бы одну степень свободы
structure-surplus = подвижность { $mobility } ({ $formula }), а должна быть 1: { $pairs } { $count ->
        [one] даёт
       *[other] дают
    } одну лишнюю связь; там { $links }; уберите оттуда одну пару или одно звено ({ structure-what-joins }: у точек, которые не шарниры, свои имена){ $cause }
structure-no-plugin = { $links } образуют группу класса { $class }, порядка { $order } ({ $pattern }); для неё не зарегистрирован плагин (см. `assur plugins`; другое входное звено может дать другие группы)
structure-pattern = внутренние { $inner }; внешние { $outer }
structure-what-joins = имя точки, стоящее в двух звеньях, образует там шарнир
structure-alike = точки `{ $one }` и `{ $other }` стоят каждая лишь в одном звене и похожи: одинаковое имя в обоих звеньях образует шарнир
structure-misses = ; движение оно не повторяет: то, что можно было бы счесть пассивным, расходится за цикл на { $misfit }
structure-slide-angles = угол пары `{ $slide }` расходится на { $off } с тем, что дают другие направляющие, и ни одно положение не подходит всем; звену, ось x которого не лежит вдоль направляющей, нужен `tilt`, здесь `tilt = "{ $tilt }"`
structure-too-many = ; лишних связей { $surplus }, а пассивные ищут не более чем среди { $most }
structure-alone = имя точки, которое стоит в двух звеньях, есть там шарнир; только в одном звене стоят { $points }
