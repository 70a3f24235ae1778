# Названия нагрузок, которых сцена не называет.
scene-unnamed-force = сила { $number } на звене { $link }
scene-unnamed-moment = момент { $number } на звене { $link }
scene-unnamed-brake = тормоз { $number } на звене { $link }
scene-unnamed-spring = пружина { $number }
scene-unnamed-contact = контакт { $number } на звене { $link }

# Ошибки сцены: что не так, исправление рядом и что разрешено.
scene-more-faults = ... и ещё { $more }
scene-fault = ошибка: { $message }
scene-place = { $file }, строка { $line }, столбец { $column }
scene-did-you-mean = возможно, `{ $name }`?
scene-did-you-mean-letters = возможно, `{ $name }`? вид одинаков, но есть буквы другого алфавита: { $codes }
scene-such-as = например { $example }
scene-and-more = { $names } и ещё { $more }
scene-key = ключ
scene-knows = { $what } — известные ключи: { $keys }
scene-add-key = добавьте `{ $key } = ...`
scene-needs-key = { $what } — нужен ключ `{ $key }`
scene-problem-of-key = `{ $key }`: { $problem }
scene-wants = нужно: { $wanted }; задано: { $got }
scene-unknown = неизвестно: { $what } `{ $name }`
scene-write-once = напишите [{ $key }] один раз
scene-one-table = одна таблица
scene-list-of-tables = список таблиц
scene-write-list = напишите [[{ $key }]]
scene-list-of-so-many = список из { $count ->
    [one] { $count } элемента
   *[other] { $count } элементов
 }
scene-in-quotes = в кавычках
scene-an-empty-text = пустой текст
scene-an-invisible-text = текст с невидимыми знаками
scene-a-text = текст
scene-one-of = одно из: { $words }
scene-true-or-false = да или нет (true, false)
scene-an-integer = целое число
scene-a-number = число
scene-a-boolean = логическое значение
scene-a-date = дата
scene-a-list = список
scene-a-table = таблица
scene-limit-not-negative = не отрицательное
scene-limit-positive = больше 0
scene-limit-direction = не более 1000 оборотов
scene-negative = не может быть отрицательным; задано: { $got }
scene-not-positive = должно быть больше 0; задано: { $got }
scene-many-turns = направление, не более 1000 оборотов; задано: { $got }
scene-without-quotes = для { $unit } пишите без кавычек
scene-no-unit = нет единицы: { $got }
scene-no-digits = в результатах не осталось бы верных цифр: верна ли единица?
scene-a-finite-number = конечное число
scene-refused-numbers = `nan`, `inf` и числа больше 1.8e308 не принимаются
scene-a-whole-number = целое число от { $least } до { $most }
scene-such-as-or-in = например { $example } или число в { $unit }
scene-got-no-number = `{ $text }` — в начале нет числа
scene-comma = запятая в числе `{ $number }`: десятичный знак — точка
scene-too-large = слишком велико: `{ $text }`, не более { $most }
scene-too-small = слишком мало: `{ $text }`, не менее { $least } или 0
scene-got-unknown-unit = неизвестная единица `{ $unit }`
scene-got-unit = `{ $unit }`, { $measures }
scene-no-quantity = такой величины в сцене нет
scene-dimension-plain-number = число без единицы
scene-dimension-length = длина
scene-dimension-angle = угол
scene-dimension-mass = масса
scene-dimension-time = время
scene-dimension-force = сила
scene-dimension-moment = момент силы
scene-dimension-speed = скорость
scene-dimension-rotation = угловая скорость
scene-dimension-acceleration = ускорение
scene-dimension-angular-acceleration = угловое ускорение
scene-dimension-inertia = момент инерции
scene-dimension-stiffness = жёсткость
scene-dimension-damping = коэффициент сопротивления
scene-dimension-power = мощность
scene-with-units = { $quantity } ({ $units })
scene-a-scene = сцена
scene-file-too-large = { $what } — не более { $most } МиБ, здесь { $size }
scene-many-tables = { $what } — не более { $most } таблиц и списков, здесь их больше
scene-right-file = тот ли это файл?
scene-unclosed = не TOML: текст не закрыт кавычкой
scene-begins-here = он начинается здесь
scene-duplicate-key = не TOML: ключ `{ $key }` повторяется
scene-stands-already = она уже есть в строке { $line }: все её ключи пишут там
scene-no-quotes = число пишут без кавычек
scene-unquoted-key = не TOML: { $message }; имя с другими знаками должно быть в кавычках
scene-no-toml = не TOML: { $message }
scene-long-name = в `{ $name }` знаков { $count }, читается не более { $most }
scene-take-shorter = возьмите имя короче
scene-many-points = точек на звеньях в сцене может быть не более { $most }, а здесь { $count }
scene-many-loads = нагрузок в сцене может быть не более { $most }, а здесь { $count }
scene-many-slides = поступательных пар в сцене может быть не более { $most }, а здесь { $count }
scene-many-links = звеньев в сцене может быть не более { $most }, а здесь { $count }
scene-one-too-many = первое лишнее
scene-the-ground = стойка
scene-tables-of-links = таблицы [link.ИМЯ]
scene-write-link = напишите [link.crank]
scene-add-links = добавьте подвижные звенья: [link.crank], [link.rod] ...
scene-no-length = у звена `{ $link }` шарниры { $pins } в одной точке: его длина нулевая
scene-give-length = задайте для них разные координаты или соедините соседние звенья одним шарниром
scene-inertia-of-others = формула момента инерции зависит от { $variables }
scene-inertia-of-q = он может зависеть только от `q`, входной координаты
scene-inertia-not-smooth = из-за `{ $function }` момент инерции имеет скачок или излом
scene-inertia-smooth = его производная входит в уравнение движения: используйте гладкие функции
scene-inertia-not-pinned = момент инерции звена `{ $link }` переменный, но ни один шарнир не соединяет его со стойкой
scene-inertia-of-a-number = задайте число или соедините звено со стойкой шарниром
scene-inertia-not-positive = `inertia` равен { $value } kg*m^2 при q = { $at }
scene-inertia-positive = момент инерции должен быть положительным и не больше { $most } везде, где проходит входное звено
scene-no-link-name = `{ $name }` не может быть именем звена
scene-no-point-name = `{ $name }` не может быть именем точки
scene-what-is-a-name = имя не может быть пустым, содержать точку или невидимые знаки
scene-ground-as-link = стойка не является подвижным звеном
scene-points-of-ground = её точки пишут в [ground]
scene-link-moment = звено не может иметь имя `moment`
scene-results-use-it = оно занято в результатах: выберите другое
scene-a-link = звено
scene-table-of-points = таблица точек
scene-why-a-center = нужен звену с массой или моментом инерции, если у него не одна точка
scene-a-slide = поступательная пара
scene-swap-slide = пусть подвижное звено скользит по "ground"
scene-slide-on-itself = звено `{ $link }` не может скользить само по себе
scene-another-link = другое звено или "ground"
scene-a-name = имя
scene-pin-and-slide = шарнир и поступательная пара имеют одно имя `{ $name }`
scene-two-slides = две поступательные пары имеют одно имя `{ $name }`
scene-own-name = дайте этой собственное имя ключом `name`
scene-name-of-a-link = имя звена
scene-a-moving-link = подвижное звено
scene-name-of-a-point = имя точки
scene-none-of-them = в сцене нет { $what ->
    [link] звеньев
    [point] точек
    [slide] поступательных пар
   *[pair] шарниров и поступательных пар
 }
scene-all-of-them = { $what ->
    [link] звенья
    [point] точки
    [slide] поступательные пары
   *[pair] шарниры и поступательные пары
 }: { $names }
scene-no-such-part = `{ $key }`: нет { $what ->
    [link] звена
    [point] точки
    [slide] поступательной пары
   *[pair] шарнира или поступательной пары
 } `{ $name }`
scene-point-or-place = точка или [x, y]
scene-no-point-on-link = `{ $key }`: на звене `{ $link }` нет точки `{ $point }`
scene-point-elsewhere = `{ $key }`: точка `{ $point }` не на звене `{ $link }`, она принадлежит: { $holders }
scene-link-without-points = на нём нет точек: задайте [x, y]
scene-points-of-link = его точки: { $points }
scene-coordinates = [x, y] или длина на оси x
scene-such-coordinates = например [0, "-400 mm"] или "120 mm"
scene-two-lengths = две длины, например ["60 mm", "70 mm"]
scene-place-of-a-point = место точки
scene-why-a-place = `r` и `angle` или `from` и `lengths`
scene-circle-of-points = место точки `{ $point }` зависит от нее самой: { $way }
scene-one-by-coordinates = задайте одну из этих точек как [x, y]
scene-triangle-one-place = у точки `{ $point }` нет места: `{ $one }` и `{ $other }` совпадают
scene-triangle-other-points = возьмите две разные точки или задайте [x, y]
scene-triangle-short = треугольник точки `{ $point }` не замыкается на { $gap }: между `{ $one }` и `{ $other }` { $apart }, больше обеих длин вместе
scene-triangle-lengthen = удлините их вместе на { $gap } или сблизьте точки
scene-triangle-long = треугольник точки `{ $point }` не замыкается на { $gap }: между `{ $one }` и `{ $other }` { $apart }, меньше разности длин
scene-triangle-shorten = укоротите более длинную или удлините более короткую на { $gap }, или раздвиньте точки
scene-needs-motion = { $what }: нужно движение, а в сцене нет [motion]
scene-add-motion = добавьте [motion] со `speed`
scene-two-loads = две нагрузки имеют одно имя `{ $name }`
scene-gravity-upward = `gravity` одним числом направлена вниз и не может быть отрицательной
scene-or-both-components = или [gx, gy]
scene-a-force = сила
scene-a-moment = момент
scene-a-brake = тормоз
scene-ground-carries = стойка несёт любую нагрузку
scene-exclude = `{ $one }` и `{ $other }` несовместимы
scene-leave-one-out = уберите одно из них
scene-why-an-angle = направление: `angle` или `against_motion = true`
scene-ground-does-not-turn = стойка не вращается
scene-a-spring = пружина
scene-a-contact = контакт
scene-two-points = две точки, например ["C", "D"]
scene-both-ends-on-link = оба конца на звене `{ $link }`
scene-such-a-spring = такая пружина не меняет длины; задайте точки двух разных звеньев
scene-point-of-link = точка или "звено.точка"
scene-not-on-link = точка `{ $point }` не на звене `{ $link }`
scene-belongs-to = она принадлежит: { $holders }
scene-arc-of-a-link = прямая принадлежит стойке, дуга — звену
scene-during-backward = `during` кончается раньше, чем начинается
scene-during-nothing = `during` имеет равные концы: контакт никогда не действует
scene-from-less-than-to = [from, to], где `from` меньше `to`
scene-add-input = добавьте [input] с `link` — звеном, которое движет остальные
scene-the-input = входное звено
scene-link-joined-to-ground = звено, соединённое со стойкой
scene-input-not-joined = входное звено `{ $link }` не соединено со стойкой
scene-join-the-input = точка, которая есть и в [ground], или [[slide]] на "ground"
scene-input-joined-often = входное звено `{ $link }` соединено со стойкой { $count ->
    [few] { $count } раза
   *[other] { $count } раз
 }: { $pairs }
scene-one-pair-of-input = там должен быть ровно один шарнир или одна поступательная пара
scene-why-an-input = одно из `link`, `slide` и `pin` говорит, что движет
scene-of-a-pin = это относится к ведущему шарниру `pin`
scene-ends-of-pin = `{ $pin }` не соединяет `{ $of }` и `{ $on }`
scene-pin-joins = он соединяет: { $links }
scene-ground-is-on = стойка — то, относительно чего движут звено
scene-swap-of-and-on = поменяйте местами `of` и `on`
scene-which-on = `{ $pin }` соединяет больше двух звеньев
scene-no-motor-between = `{ $key }` требует звена, которое движут относительно стойки
scene-torque-between = задайте `torque`: нагрузку привода между обоими звеньями
scene-cycle-or-range = либо целый цикл, либо промежуток
scene-no-range = `to` равно `from`, а `positions` = { $positions }
scene-one-position-or-another-end = positions = 1 или другой конец
scene-why-to = поступательный вход не имеет собственного цикла: задайте `to` или `cycle`
scene-an-input = вход
scene-law-over-time = закон по времени
scene-needs-one-input = { $what }: нужен один вход, а со списком входов координата — время
scene-law-prescribes = { $what }: не нужно рядом с `over_time`, который задает движение
scene-not-over-coordinate = { $what }: нужен вход без `over_time`, ведь с ним координата — время
scene-over-time-instead = задайте по времени: таблицей с `over = "time"` или формулой от `t`
scene-formula-of = формула от { $variables }
scene-add-motion-until = добавьте [motion] с `until` — временем, когда движение заканчивается
scene-why-until = время, когда движение заканчивается
scene-why-a-law = таблица строк [время, координата] или формула от времени `t`
scene-not-from-zero = начинается с времени 0, а в первой строке { $got }
scene-single-row = нужны хотя бы две строки
scene-times-repeat = время в строках должно возрастать
scene-law-without-jumps = координата не может прыгать: уберите строку или дайте ей более позднее время
scene-until-beyond = `until` равно { $until }, а в последней строке { $last }
scene-longer-or-closed = добавьте строки или закончите движение там; повторяется лишь таблица, которая заканчивается первым значением
scene-law-of-others = формула закона по времени зависит от { $variables }
scene-law-of-t = она может зависеть лишь от `t`, времени в секундах
scene-law-without-value = закон имеет бесконечную или чрезмерную координату, скорость или ускорение при { $at }
scene-law-within-limits = он должен действовать от 0 до `until`
scene-driven-twice = два входа движут пару { $pair } тех же звеньев
scene-the-motion = движение
scene-other-motion = `{ $key }` относится к движению вида "{ $owner }", а это — "{ $kind }"
scene-motion-knows = движение вида "{ $kind }" — известные ключи: { $keys }
scene-name-of-integrator = название метода интегрирования
scene-large-tolerance = `tolerance` — относительный допуск, меньше 1; задано: { $got }
scene-time-or-travel = { $time } или { $travel }
scene-end-of-motion = { $time }, { $travel }, "rest" или "turn"
scene-many-samples = `samples` может быть не более { $most }: в сцене звеньев, точек, поступательных пар и нагрузок вместе { $parts }
scene-kept-in-memory = их числа хранятся в памяти
scene-steady-without-cycle = установившемуся движению нужен цикл, а входное звено движется в промежутке
scene-give-a-cycle = задайте входному звену `cycle`
scene-large-unevenness = `unevenness` — это (наибольшая − наименьшая) / средняя скорость, меньше 2; задано: { $got }
scene-leave-it-out = уберите
scene-the-balance = уравновешивание
scene-why-at-and-angle = сила имеет `at` и `angle`, момент — ни одного из них
scene-the-output = вывод
scene-list-of-names = список имён
scene-ground-does-not-move = стойка неподвижна
scene-name-of-a-slide = имя поступательной пары
scene-name-of-a-pair = имя шарнира или поступательной пары
scene-pins = шарниры: { $pins }
scene-point-is-no-pin = точка `{ $point }` не шарнир: она принадлежит только одному звену
scene-the-note = записка
scene-list-of-positions = список номеров положений
scene-here-are = здесь { $count }
scene-the-drive = привод
scene-large-efficiency = `efficiency` больше 0 и не более 1; задано: { $got }
scene-drive-without-motion = [drive] требует движения вида "transient" или "steady", а в сцене движения нет
scene-drive-of-prescribed = [drive] требует движения вида "transient" или "steady", а это — "prescribed"
scene-kept-by-balance = заданное движение поддерживает уравновешивающая нагрузка
scene-key-of-motor = `{ $key }` относится к двигателю, а у привода его нет
scene-add-motor = добавьте `motor = ...` или уберите
scene-flywheel-on-no-motor = маховик на двигателе, а у привода двигателя нет
scene-no-flywheel = `flywheel_on` без `flywheel`
scene-add-flywheel = добавьте `flywheel = "solve"` или момент инерции
scene-input-slides = `{ $key }` требует вращательного входного звена, а это поступательное
scene-solve-needs-steady = `{ $key } = "solve"` требует движения вида "steady"
scene-number-for-transient = для неустановившегося движения задайте число
scene-flywheel-needs-unevenness = `flywheel = "solve"` требует `unevenness` в [motion]
scene-unevenness-needs-motor = `unevenness = "motor"` требует [drive] с двигателем и `flywheel = "solve"`
scene-word-or = "{ $word }" или { $quantity }
scene-empty-drive = `motor`, `torque` или `flywheel`: пустой привод ничего не делает
scene-name-of-catalogue = название каталога
scene-kloss-needs-ratio = `characteristic = "kloss"` требует `max_torque_ratio`
scene-or-linear = или characteristic = "linear"
scene-key-of-catalogue = `{ $key }` относится к двигателю из каталога, а этот задан своими данными
scene-designation = обозначение, "auto" или номинальные данные
scene-a-motor = двигатель
scene-no-slip = `rated_speed` должна быть меньше `synchronous_speed`
scene-motor-slips = асинхронный двигатель имеет скольжение
scene-small-torque-ratio = `max_torque_ratio` должно быть больше 1; задано: { $got }
scene-breakdown-by-rated = критический момент / номинальный момент
scene-a-formula = формула
scene-table-over-angle = таблица по углу
scene-table-over-time-or-speed = таблица по времени или скорости
scene-table-over-stroke = таблица по ходу
scene-stroke-of-a-force = ход есть только у точки приложения силы
scene-other-arguments = over = "angle" (или "coordinate"), "time" или "speed"
scene-scale-out-of-range = из-за `scale` величина нагрузки { $size } вне пределов
scene-right-unit-and-factor = в результатах не осталось бы верных цифр: верны ли единица и множитель?
scene-table-of-a-load = таблица нагрузки
scene-all-arguments = over = "angle" (или "coordinate"), "time", "speed" или "stroke"
scene-a-unit = единица
scene-formula-of-motion = формула с `w` или `t`
scene-axis-without-x = `axis` лишний: в формуле нет `x`
scene-x-along-axis = `x` — положение точки вдоль `axis`
scene-x-of-a-force = положение `x` есть только у точки приложения силы
scene-use-other-variables = используйте `q`, `w` или `t`
scene-repeat-without-cycle = `repeat` требует цикла, а входное звено движется в промежутке
scene-long-table = таблица охватывает { $span }, а цикл имеет { $cycle }
scene-shorten-table = `repeat = false`, более длинный `cycle` входного звена или меньше строк
scene-forward-or-back = `forward`, `back` или оба
scene-row-outside-stroke = есть строка при { $at }, а ход длится от 0 до 1
scene-list-of-rows = список строк
scene-no-rows = нет строк
scene-many-rows = строк { $count }, читается не более { $most }
scene-leave-rows-out = уберите часть строк: между ними проводятся прямые
scene-rows-decrease = первые числа строк не могут убывать
scene-smaller-than-before = меньше, чем в предыдущей строке
scene-rows-of-two = строки из двух чисел
scene-no-list = `{ $key }` — не список
scene-single-value = `{ $key }` — одно значение без частей
scene-table-is-no-list = { $owner } — не список; там есть: { $names }
scene-no-elements = { $owner } — элементов нет
scene-elements = { $owner } — элементов { $count }, от [0] до [{ $last }]
scene-list-without-names = { $owner } — список без имён: назовите элемент номером, например `{ $list }[0]`
scene-or-by-number = { $problem }, или назовите элемент номером, например `{ $list }[0]`
scene-several-values = `{ $key }` — несколько значений
scene-is-a-table = `{ $key }` — таблица; там есть: { $names }
scene-is-a-list = `{ $key }` — список; там есть: { $names }
scene-is-a-boolean = `{ $key }` — логическое значение, а не число
scene-is-a-date = `{ $key }` — дата, а не число
scene-the-scene = сцена
scene-default-not-written = значение по умолчанию нужно записать в сцене, чтобы его менять
scene-owner-has-no = { $owner }: нет `{ $name }`; { $hint }; там есть: { $names }
scene-nothing = ничего
scene-angle-of-sliding = трение задано как `against_sliding`, а `angle` зависит не только от координаты входного звена
scene-law-over-coordinate = число либо таблица или формула по координате входного звена
scene-friction-against-sliding = трение против скольжения

## friction in pairs
scene-a-friction = трение
scene-friction-in-free-motion = с сухим трением в парах движение, следующее из уравнения движения, создаёт привод входного звена: другой уравновешивающей нагрузки у него нет
scene-friction-prescribed = уберите `[balance]` или задайте движение (`kind = "prescribed"`)
scene-friction-twice = трение пары { $pair } уже задано
scene-friction-of-slides = `{ $key }` относится к трению поступательной пары, а эта пара вращательная
scene-friction-of-pins = `{ $key }` относится к трению вращательной пары, а эта пара поступательная
scene-friction-owner = звено `{ $link }` не соединено этим шарниром
scene-friction-without-length = `{ $key }` требует длины контакта
scene-friction-add-length = добавьте `length` или уберите этот ключ
scene-hardly-meant = `{ $key }` = { $number } взято в { $unit }, то есть { $is }; если имелось в виду другое, напишите { $instead }.
scene-formula-as-number = — формула на месте числа: { $text }
scene-same-appearance = Точка `{ $name }` ({ $codes }) выглядит как точка `{ $other }`, но содержит буквы другого алфавита: это две разные точки.
scene-negative-length = Точка `{ $point }` задана одним отрицательным числом, то есть координатой x: звено развёрнуто, и его угол иной на 180°. Длина положительна: напишите { $length } или { $place }, если имелась в виду координата.
scene-far-longer = Звено `{ $link }` имеет длину { $length }, остальные — около { $others }: верна ли единица?
scene-great-inertia = Момент инерции звена `{ $link }` имеет радиус инерции { $radius }, а размер механизма { $size }: верна ли единица?
scene-far-center = Центр масс звена `{ $link }` лежит в { $distance } от его точек, а размер механизма { $size }: верна ли единица?
scene-long-links = Большинство звеньев имеет длину около { $length }: не пропущена ли единица? Число без единицы — в м.
scene-friction-short-contact = должно быть не менее 0,001 мм, а есть { $got }; без него ползун прижат в одной точке

## the reference of the keys
scene-either = { $these } или { $last }
scene-kind-by-input = { $turning }, если входное звено вращается, { $sliding }, если оно скользит
scene-kind-count = целое число
scene-kind-name = имя { $what ->
    [link] звена
    [point] точки
    [slide] поступательной пары
    [pair] шарнира или поступательной пары
    [motor] двигателя
   *[plugin] плагина
 }
scene-kind-place = точка звена, [x, y] в его системе или длина на его оси x
scene-kind-two = список из двух: { $of }
scene-kind-list = список: { $of }
scene-kind-table = таблица: { $header }
scene-the-assembly = сборка
scene-key-elsewhere = его место в { $tables }
scene-key-title = Название для заголовков и рисунков.
scene-key-gravity = Ускорение свободного падения: одно число направлено вниз, два являются составляющими; без него звенья не имеют веса.
scene-key-ground = Стойка, звено 0, с неподвижными точками.
scene-key-link = Подвижные звенья; имя точки, употреблённое в двух звеньях, — это шарнир между ними.
scene-key-slide = Поступательные пары: одно звено скользит по другому вдоль прямой.
scene-key-input = Входное звено, его координата и положения, которые вычисляются; или список входов [[input]], каждый по времени.
scene-key-assembly = Примерно где находятся точки в первом положении: по ним выбирается вариант сборки групп.
scene-key-force = Сила в точке звена.
scene-key-moment = Момент на звено, положительный против часовой стрелки.
scene-key-spring = Пружина, демпфер или оба между точками двух звеньев.
scene-key-contact = Дуга звена, которая катится и скользит по прямой стойки.
scene-key-friction = Сухое трение в шарнире или в поступательной паре; без него пара идеальна.
scene-key-brake = Колодка, прижатая к диску: момент против движения звена.
scene-key-balance = Нагрузка, которая поддерживает заданное движение; без нее она действует на входное звено.
scene-key-motion = Как движется входное звено; без этого вычисляются передаточные функции, а при нагрузках — статика.
scene-key-drive = Двигатель, редуктор и маховик, для неустановившегося или установившегося движения.
scene-key-output = Вычисляется только это; без этого все, что сцена позволяет.
scene-key-note = Титульный лист и язык `assur report`.
scene-key-points-of-ground = Точки стойки по именам: [x, y], одно число на оси x или таблица: полярные координаты или расстояния от двух точек.
scene-key-points = Точки по именам в собственной системе звена, начало и ось x которой вы выбираете: [x, y], одно число на оси x или таблица: полярные координаты или расстояния от двух точек. Имя в двух звеньях — это шарнир; длины звеньев — расстояния между их точками.
scene-key-place-r = Расстояние от начала системы звена или от точки `about`.
scene-key-place-angle = Направление от оси x звена, против часовой стрелки.
scene-key-place-about = Точка того же звена, от которой отмерено `r`; если ее нет — начало системы звена.
scene-key-place-from = Две точки того же звена, от которых у точки расстояния `lengths`.
scene-key-place-lengths = Расстояния от двух точек `from` в их порядке.
scene-key-place-side = С какой стороны линии от первой точки ко второй лежит точка, если смотреть вдоль линии.
scene-key-mass = Масса звена; без нее звено невесомо.
scene-key-center = Центр масс; можно не указывать, если у звена одна точка.
scene-key-inertia = Момент инерции относительно центра масс; для звена, соединенного шарниром со стойкой, также формула от входной координаты.
scene-key-slide-link = Звено, которое скользит.
scene-key-slide-on = Звено, которое несет направляющую, или "ground".
scene-key-slide-through = Точка направляющей прямой в системе звена, которое ее несет; без нее начало этой системы.
scene-key-slide-angle = Направление направляющей прямой в системе звена, которое ее несет.
scene-key-slide-point = Точка ползуна, которая остается на направляющей прямой; без нее его первая точка.
scene-key-slide-tilt = Угол оси x ползуна от направления направляющей.
scene-key-slide-name = Ее имя в результатах; без него link/on.
scene-key-input-link = Входное звено: соединено шарниром со стойкой или скользит по ней.
scene-key-input-slide = Вместо `link`: ползун, который движет; между двумя подвижными звеньями — цилиндр; координата — его перемещение.
scene-key-input-pin = Вместо `link`: шарнир, который движет, — двигатель в соединении двух звеньев; координата — угол оси x звена `of` минус угол оси x звена `on`.
scene-key-input-of = Звено, которое поворачивает ведущий шарнир.
scene-key-input-on = Звено, относительно которого ведущий шарнир поворачивает `of`; нужно, где шарнир соединяет больше двух звеньев.
scene-key-input-from = Координата первого положения: угол оси x звена или перемещение его ползуна.
scene-key-input-positions = Сколько положений вычисляется: равномерно за цикл, без повторения его конца.
scene-key-input-cycle = Ход входного звена, после которого все повторяется; без него один оборот.
scene-key-input-direction = Направление изменения координаты: "ccw" растет, "cw" убывает.
scene-key-input-to = Координата последнего положения вместо цикла; входному ползуну нужна она или цикл.
scene-key-input-name = Как координата называется на осях и в таблицах; без него "координата" и входное звено.
scene-key-input-over-time = Координата по времени, вместо `from` и того, что ее движет: в [motion] тогда лишь `until` и `samples`.
scene-key-inputs-from = Координата при времени 0: угол оси x звена или перемещение его ползуна.
scene-key-input-rate = На сколько координата растет за секунду, со знаком; без [motion] не используется.
scene-key-time-table = Строки [время, координата], первая при времени 0, время возрастает; таблица, которая заканчивается первым значением, повторяется.
scene-key-time-shape = Строки соединены отрезками, между которыми скорость прыгает, или кубическим сплайном: естественным, а где первое значение равно последнему — периодическим.
scene-key-time-formula = Формула лишь от t (время, с), в рад или м; скорость и ускорение — ее производные.
scene-key-assembly-point = Точка механизма и примерно где она находится в первом положении.
scene-key-load-name = Его имя в результатах и в ключах.
scene-key-load-link = Звено, на которое оно действует.
scene-key-scale = Множитель величины нагрузки, который можно варьировать.
scene-key-force-at = Точка звена, в которой действует сила.
scene-key-force-angle = Направление силы, против часовой стрелки от оси x; сила сопротивления направлена против движения.
scene-key-force-frame = В чьей системе отсчитывается угол: стойки или звена.
scene-key-value = Его величина: число, таблица от угла, времени, скорости или хода либо формула.
scene-key-against-motion = Вместо угла: сила всегда противоположна скорости своей точки.
scene-key-moment-against = Момент всегда противоположен вращению своего звена; его значение — сопротивление при любом направлении вращения.
scene-key-spring-between = Два ее конца: точки двух звеньев, записанные "link.point", если имени мало.
scene-key-spring-stiffness = Жесткость пружины.
scene-key-spring-length = Свободная длина пружины.
scene-key-spring-damping = Демпфирование вдоль линии между концами.
scene-key-contact-center = Центр дуги.
scene-key-contact-radius = Радиус дуги.
scene-key-contact-angle = Где на дуге действует сила, от ее нижней точки по часовой стрелке.
scene-key-contact-force = Сила на дугу, к ее центру.
scene-key-contact-friction = Коэффициент трения со знаком или таблица, знак в которой следует из скольжения.
scene-key-contact-during = Интервал входной координаты, в котором есть контакт; без него всегда.
scene-key-against-sliding = Коэффициент трения против скольжения.
scene-key-brake-radius = Радиус диска.
scene-key-brake-force = Сила на рычаге.
scene-key-brake-lever = Во сколько раз рычаг увеличивает силу.
scene-key-brake-friction = Коэффициент трения между колодкой и диском.
scene-key-over = От чего зависит величина: от входной координаты, времени, входной скорости или хода точки силы.
scene-key-table = Строки [аргумент, величина] по возрастанию; две строки с одним аргументом дают скачок.
scene-key-shape = Строки соединены прямыми, или каждая величина действует до следующей строки.
scene-key-repeat = Повторяется ли таблица от угла с циклом; без этого повторяется, если цикл есть.
scene-key-axis = Направление, вдоль которого измеряется ход точки.
scene-key-forward = Величина, пока точка движется вдоль оси: число или строки от ее места от 0 до 1.
scene-key-back = Величина, пока точка возвращается: число или строки от ее места вдоль оси, от 0 до 1, как у `forward`.
scene-key-formula = Формула от q (координата, рад или м), w (скорость, положительная вдоль `direction`: сопротивление входу — -5*w, где он вращается против часовой стрелки, 5*w, где по ней), t (время), x (место точки вдоль оси, от 0 до 1) в SI, с sin cos tan asin acos atan atan2 sqrt exp ln abs sign min max step pi; углы в радианах.
scene-key-inertia-formula = Гладкая формула от q, входной координаты, положительная везде, куда попадает входное звено.
scene-key-unit = Единица результата формулы; без нее SI.
scene-key-friction-pair = Шарнир или поступательная пара, в которой действует трение.
scene-key-friction-coefficient = Коэффициент трения.
scene-key-friction-radius = Радиус цапфы.
scene-key-friction-owner = Звено, которому принадлежит цапфа; без него стойка, иначе первое звено шарнира в порядке файла.
scene-key-friction-length = Длина контакта вдоль направляющей: сила и момент давят на ее концы; без нее давление в одной точке.
scene-key-friction-middle = С чем движется середина контакта: с точкой ползуна или с направляющей.
scene-key-friction-offset = Расстояние поверхностей скольжения от направляющей прямой, с обеих сторон; нужна длина.
scene-key-balance-link = Звено, на которое действует уравновешивающая нагрузка.
scene-key-balance-at = Точка уравновешивающей силы; без нее действует момент.
scene-key-balance-angle = Направление уравновешивающей силы.
scene-key-motion-kind = Заданное: скорость и ускорение даны; неустановившееся: следует из нагрузок и привода; установившееся: периодический режим.
scene-key-motion-speed = Скорость входного звена вдоль его направления в первом положении; заданному движению она нужна, неустановившееся без нее начинается из покоя.
scene-key-motion-acceleration = Ускорение входного звена вдоль его направления.
scene-key-motion-until = Конец: время, ход входного звена, "rest" (окончательная остановка) или "turn" (первый реверс); движения по времени — время.
scene-key-motion-samples = Сколько равноотстоящих моментов после первого приводится.
scene-key-motion-integrator = Зарегистрированный метод (`assur plugins`); "auto" выбирает его.
scene-key-motion-tolerance = Относительный допуск интегрирования.
scene-key-motion-step = Шаг методов с постоянным шагом: время или ход входного звена.
scene-key-motion-max-steps = После стольких шагов интегрирование прекращается.
scene-key-motion-mean-speed = Среднее наибольшей и наименьшей скорости входного звена.
scene-key-motion-unevenness = (max - min) / mean входной скорости, 0.05 или "1/20"; "motor": наибольшая, при которой двигатель остается на рабочем участке.
scene-key-drive-motor = Обозначение из каталога, "auto" для наименьшего подходящего или номинальные данные.
scene-key-drive-catalogue = Каталог, в котором ищется двигатель (`assur plugins`).
scene-key-drive-max-motor-speed = Наибольшая синхронная скорость двигателя, который берет "auto".
scene-key-drive-characteristic = Момент от скорости: по формуле Клосса или прямой рабочий участок.
scene-key-drive-ratio = Скорость двигателя к входной скорости; "solve" находит его.
scene-key-drive-efficiency = КПД редуктора.
scene-key-drive-torque = Вместо двигателя: постоянный момент (для входного ползуна сила) вдоль направления; "balance" делает работу за цикл нулевой.
scene-key-drive-flywheel = Момент инерции маховика; "solve" находит его по неравномерности.
scene-key-drive-flywheel-on = Вал, который несет маховик.
scene-key-motor-power = Номинальная мощность.
scene-key-motor-synchronous-speed = Синхронная скорость.
scene-key-motor-rated-speed = Номинальная скорость, меньше синхронной.
scene-key-motor-max-torque-ratio = Критический момент к номинальному; нужен для "kloss".
scene-key-motor-inertia = Момент инерции ротора.
scene-key-output-names = Имена того, что вычисляется; группы, от которых ничто из этого не зависит, не решаются.
scene-key-note-author = Кто выполнил.
scene-key-note-group = Группа автора.
scene-key-note-variant = Вариант задания.
scene-key-note-language = Язык записки, чертежей и текстов.
scene-key-note-positions = Номера положений, которые чертятся и расписываются; без них выбирает программа.
scene-key-of-sorts = он принадлежит другому виду: { $sorts }

## what is hardly meant in loads and motion
scene-typographic-quotes = это кавычки текстового процессора: пишите " перед и после
scene-unquoted-quantity = число с единицей пишется в кавычках: "{ $value }"
scene-decimal-comma = запятая здесь — десятичный разделитель? им должна быть точка
scene-small-inertia = Момент инерции звена `{ $link }` имеет радиус инерции { $radius }, а длина звена { $size }: не ошибочна ли единица?
scene-far-heavier = Звено `{ $link }` имеет массу { $mass }, остальные примерно { $others }: не ошибочна ли единица?
scene-odd-gravity = Ускорение свободного падения { $size }; на Земле оно 9.81 m/s^2. Пишите "9.81 m/s^2" или уберите `gravity`.
scene-fast = Звенья двигались бы со скоростью { $speed } и больше, которой не выдержит ни один материал: скорость в другой единице?
scene-rough = Коэффициент трения { $found } не имеет ни одна пара твердых тел; не в процентах ли он?
scene-great-journal = Цапфа имеет радиус { $radius }, а размер механизма { $size }: не ошибочна ли единица?
scene-empty-output = [output] ничего не называет, поэтому ничего не вычисляется: назовите точки, звенья, поступательные пары или реакции или уберите ее.
scene-long-spring = Пружина имеет свободную длину { $length }, а размер механизма { $size }: не ошибочна ли единица?
scene-spring-without-stiffness = У пружины нет ни `stiffness`, ни `damping`, поэтому нет силы: не пропущена ли жёсткость?
scene-strong = Нагрузка соответствует силе { $force } на механизм размером { $size }, которой не выдержит никакая сталь: не ошибочна ли единица?
scene-long-time = Таблица от времени доходит до { $last }, а движение длится { $lasts }: время в другой единице?
scene-drives-clockwise = Этот момент движет вход при любой скорости: `w` — скорость вдоль `direction`, а момент положителен против часовой стрелки; сопротивление входу, который вращается по часовой стрелке, положительно: `5*w`.
scene-degrees-in-formula = `{ $function }` берет радианы, а здесь ее аргумент похож на градусы: для 30 градусов пишите 30*pi/180, а q уже в радианах.
scene-negative-against = Отрицательное `value` против движения движет механизм: уберите минус.
scene-key-at-top = он должен стоять в начале файла, перед первой [таблицей]
scene-comment-sign = не TOML: комментарий начинается с `#`
scene-colon = не TOML: ключ и его значение соединяет `=`
scene-semicolon = не TOML: строка кончается без `;`
scene-round-brackets = не TOML: координаты и списки пишут в квадратных скобках: [x, y]
scene-invisible-sign = не TOML: здесь есть невидимый символ { $code }: замените его пробелом
scene-missing-comma = не TOML: между двумя значениями не хватает запятой
scene-unclosed-brace = не TOML: эта фигурная скобка в её строке не закрыта
scene-missing-value = не TOML: здесь не хватает значения
scene-unquoted-text = не TOML: текст пишут в кавычках: "{ $value }"
scene-form-of-number = не TOML: напишите число так: { $number }
scene-unclosed-header = не TOML: у имени этой таблицы нет закрывающей скобки
scene-key-without-value = не TOML: после ключа `{ $key }` должны стоять `=` и его значение
scene-example-or-word = { $example } или "{ $word }"
scene-grouped-digits = содержит пробел в числе: `{ $text }`; пишите его цифры слитно
scene-degrees-in-table = число без единицы - в радианах: для градусов пишите "360 deg"
scene-list-repeats = С `to` расстояние между { $positions } положениями равно { $apart }, и последнее повторяет первое: уберите `to` или напишите positions = { $more }.
scene-part-of-a-turn = Цикл { $cycle } - не целое число оборотов: после него механизм не возвращается туда, где начинал. Положения на части оборота задают через `to`.
scene-gravity-up = Сила тяжести направлена вверх: y растёт вверх. Напишите "9.81 m/s^2" или [0, "-9.81 m/s^2"].
scene-inertia-without-mass = Звено `{ $link }` не вращается вокруг неподвижного шарнира и имеет момент инерции, но не имеет массы: не пропущено ли `mass`?
scene-mass-without-inertia = Звено `{ $link }` вращается и имеет массу, но не имеет момента инерции, который есть у других: он принят за 0; добавьте `inertia` (0, если так и нужно)
scene-far-lighter = Звено `{ $link }` имеет массу { $mass }, остальные - около { $others }: не ошибочна ли единица?
scene-turned-twice = Отрицательная скорость вдоль direction = "cw" - это вращение против часовой стрелки: уберите минус.
scene-odd-ratio = `ratio` - это скорость двигателя / скорость входного звена; с { $ratio } двигатель далёк от номинальной скорости, её дало бы { $needed }.
scene-great-torque-ratio = `max_torque_ratio` = { $found } - это критический момент в { $found } раз больше номинального, а у двигателей от 1.5 до 4; если это проценты, напишите { $part }.
scene-table-ends = Таблица кончается на { $last }, а цикл на { $end }: дотуда держится { $held }, потом скачок к { $first }. Если так и нужно, напишите `repeat = true`, иначе строку для { $end }.
scene-unevenness-unused = `unevenness` ничего не меняет: по нему находят маховик, а его не ищут. Напишите flywheel = "solve" в [drive] или уберите его.
scene-counted-twice = { $point } стоит под углом { $angle } в системе координат входного звена, а `from` поворачивает её ещё на столько же: { $point } начинает с { $twice }. Поставьте { $point } на ось x своего звена или уберите `from`.
scene-the-sheet = лист
scene-list-of-fields = список полей
scene-many-positions-of-sheet = `{ $key }` листа имеет не больше { $most } положений
scene-key-sheet = Формат, поля и основная надпись `assur sheet`.
scene-key-sheet-format = Формат листа; без него — наименьший от A4 до A1, на котором помещаются поля, а если и A1 мал — несколько листов A1.
scene-key-sheet-positions = Положения, начерченные одно на другом: сколько их за цикл или их номера.
scene-key-sheet-plans = Номера положений планов и многоугольников; без них — те, что в записке.
scene-key-sheet-fields = Поля листа по порядку, из `mechanism`, `diagrams`, `velocities`, `accelerations`, `forces`, `lever`, `dynamics`, `results`; без ключа — те, что есть в сцене.
scene-key-sheet-number = Обозначение чертежа для основной надписи.
scene-a-text-by-language = текст или таблица языков
scene-text-by-language = текст по языкам
scene-an-empty-table = пустая таблица
scene-table-of-labels = таблица точек с подписями
scene-write-labels = например { "[labels]" } с { "A = \"A₁\"" }
scene-columns-of-a-diagram = столбцы результатов через запятую
scene-list-of-diagrams = список графиков
scene-list-of-chapters = список разделов
scene-many-of-note = `{ $key }` записки имеет не больше { $most } элементов
scene-key-labels = Как читатели называют точки.
scene-key-labels-point = Как читатели называют эту точку; в файлах и ключах — её имя.
scene-key-label = Как это называют читатели, на одном языке или нескольких; в файлах и ключах — имя.
scene-key-language-en = Текст на английском.
scene-key-language-uk = Текст на украинском.
scene-key-language-ru = Текст на русском.
scene-key-note-ministry = Министерство, для титульного листа.
scene-key-note-university = Университет, для титульного листа.
scene-key-note-department = Кафедра, для титульного листа.
scene-key-note-discipline = Дисциплина, для титульного листа.
scene-key-note-supervisor = Руководитель работы.
scene-key-note-city = Город, для титульного листа.
scene-key-note-year = Год, для титульного листа.
scene-key-note-task = Текст задания; пустая строка разделяет абзацы.
scene-key-note-curves = Дополнительные графики: столбцы по заголовку, имени в { "CSV" } или словам; несколько через запятую — друг над другом.
scene-key-note-chapters = Разделы, которые она имеет, из { "results, task, structure, kinematics, forces, dynamics, energy, working, checks, model, sources, conclusions" }; без ключа — все, что есть в сцене.
scene-key-note-digits = Значащие цифры её чисел.
