structure-group = група { $number } ({ $kind } { $links })
    .short = група { $number }
structure-links-named = { $count ->
        [one] ланка
       *[other] ланки
    } { $links }
structure-pairs = { $count ->
        [one] пара
       *[other] пари
    } { $pairs }
structure-some = { $names } ... (показано { $shown } з { $total })
structure-loose = ступінь рухомості { $mobility } ({ $formula }), а механізм рухає один вхід: { $links } { $count ->
        [one] може
       *[other] можуть
    } рухатися при нерухомому вході{ $also }; приєднайте { $count ->
        [one] її
       *[other] їх
    } до іншої ланки ще однією парою або приберіть те, що там незакріплене ({ $hint })
structure-loose-also = {" "}(водночас пари { $pairs } мають одну зайву в’язь)
structure-more-inputs = механізм має { $mobility } ступені вільності ({ $formula }), тож входів йому треба { $mobility }, а є { $inputs }. За нерухомих входів { $links } ще можуть рухатися: задайте решту як записи `[[input]]` або заберіть ці ступені ще однією парою чи ланкою менше
structure-dependent-input = вхід `{ $input }`: те, що він рухає, вже визначають входи перед ним; ступенів вільності { $mobility } ({ $formula }), входів { $inputs }. Приберіть цей вхід або приведіть іншу пару
structure-surplus = ступінь рухомості { $mobility } ({ $formula }), а має бути { $inputs }: { $pairs } { $count ->
        [one] дає
       *[other] дають
    } одну зайву в’язь; там { $links }; приберіть звідти одну пару або одну ланку ({ structure-what-joins }: точки, що не є шарнірами, повинні мати власні імена){ $block }{ $cause }
structure-missing-block = ; якщо палець має рухатися вздовж паза ланки `{ $on }`, то бракує його каменя: окремої ланки, яка з’єднана шарніром із ланкою `{ $link }`{ $at } і ковзає по `{ $on }`
structure-at-point = {" "}у точці `{ $point }`
structure-no-plugin = { $links } утворюють групу класу { $class }, порядку { $order } ({ $pattern }); для неї не зареєстровано плагіна (див. `assur plugins`; інша вхідна ланка може дати інші групи)
structure-pattern = внутрішні { $inner }; зовнішні { $outer }
structure-what-joins = ім’я точки, ужите у двох ланках, утворює там шарнір
structure-alike = точки `{ $one }` і `{ $other }` є кожна лише в одній ланці та мають схожі імена: однакове ім’я в обох ланках утворює шарнір
structure-slide-angles = кут пари `{ $slide }` розходиться на { $off } з тим, чого вимагають інші напрямні, тож жодне положення не задовольняє всіх; ланці, вісь x якої не лежить уздовж напрямної, потрібен `tilt`, тут `tilt = "{ $tilt }"`
structure-slide-on-pinned = у поступальній парі `{ $slide }` рухатися нема чому: ті самі дві ланки з’єднує шарнір `{ $pin }`
structure-alone = ім’я точки, ужите у двох ланках, утворює там шарнір; лише в одній ланці є точки { $points }
structure-passive-link = ланка «{ $link }»
structure-passive-pair = пара { $pair } ланки «{ $link }»
