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
scene-right-file = тот ли это файл?
scene-unclosed = не TOML: текст не закрыт кавычкой
scene-begins-here = он начинается здесь
scene-duplicate-key = не TOML: ключ `{ $key }` повторяется
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
scene-give-length = дайте им разные координаты или соедините соседние звенья одним шарниром
scene-inertia-of-others = формула момента инерции зависит от { $variables }
scene-inertia-of-q = он может зависеть только от `q`, входной координаты
scene-inertia-not-smooth = из-за `{ $function }` момент инерции имеет скачок или излом
scene-inertia-smooth = его производная входит в уравнение движения: используйте гладкие функции
scene-inertia-not-pinned = момент инерции звена `{ $link }` переменный, но ни один шарнир не соединяет его со стойкой
scene-inertia-of-a-number = дайте число или соедините звено со стойкой шарниром
scene-inertia-not-positive = `inertia` равен { $value } kg*m^2 при q = { $at }
scene-inertia-positive = момент инерции должен быть положительным везде, где проходит входное звено
scene-no-link-name = `{ $name }` не может быть именем звена
scene-no-point-name = `{ $name }` не может быть именем точки
scene-what-is-a-name = имя не может быть пустым, содержать точку или невидимые знаки
scene-ground-as-link = стойка не является подвижным звеном
scene-points-of-ground = её точки пишут в [ground]
scene-link-moment = звено не может иметь имя `moment`
scene-results-use-it = оно занято в результатах: выберите другое
scene-a-link = звено
scene-table-of-points = таблица точек
scene-why-a-center = нужен звену, у которого есть масса или момент инерции и не одна точка
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
scene-link-without-points = на нём нет точек: дайте [x, y]
scene-points-of-link = его точки: { $points }
scene-coordinates = [x, y] или длина на оси x
scene-such-coordinates = например [0, "-400 mm"] или "120 mm"
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
scene-such-a-spring = такая пружина не меняет длины; дайте точки двух разных звеньев
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
scene-cycle-or-range = либо целый цикл, либо промежуток
scene-no-range = `to` равно `from`, а `positions` = { $positions }
scene-one-position-or-another-end = positions = 1 или другой конец
scene-why-to = поступательный вход не имеет собственного цикла: дайте `to` или `cycle`
scene-the-motion = движение
scene-other-motion = `{ $key }` относится к движению вида "{ $owner }", а это — "{ $kind }"
scene-motion-knows = движение вида "{ $kind }" — известные ключи: { $keys }
scene-name-of-integrator = название метода интегрирования
scene-large-tolerance = `tolerance` — относительная погрешность, меньше 1; задано: { $got }
scene-time-or-travel = { $time } или { $travel }
scene-end-of-motion = { $time }, { $travel }, "rest" или "turn"
scene-many-samples = `samples` может быть не более { $most }: в сцене звеньев, точек, поступательных пар и нагрузок вместе { $parts }
scene-kept-in-memory = их числа хранятся в памяти
scene-steady-without-cycle = установившемуся движению нужен цикл, а входное звено движется в промежутке
scene-give-a-cycle = дайте входному звену `cycle`
scene-large-unevenness = `unevenness` — это (наибольшая − наименьшая) / средняя скорость, меньше 2; задано: { $got }
scene-point-on-ground = точка `{ $point }` на стойке: её место известно
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
scene-many-positions-of-note = в записке не более { $most } положений
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
scene-number-for-transient = для неустановившегося движения дайте число
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
scene-other-arguments = over = "angle", "time" или "speed"
scene-scale-out-of-range = из-за `scale` величина нагрузки { $size } вне пределов
scene-right-unit-and-factor = в результатах не осталось бы верных цифр: верны ли единица и множитель?
scene-table-of-a-load = таблица нагрузки
scene-all-arguments = over = "angle", "time", "speed" или "stroke"
scene-a-unit = единица
scene-formula-of-motion = формула с `w` или `t`
scene-axis-without-x = `axis` ни к чему: в формуле нет `x`
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
scene-bracket-not-closed = `[` не закрыта
scene-key-continues = ключ продолжается через `.` или `[`, а не `{ $rest }`
scene-no-index = `[{ $index }]` не является элементом: пишите целое число от 0, два числа как в `[1..2]` или `[*]` для всех
scene-quote-not-closed = кавычка не закрыта
scene-what-is-a-key = ключ состоит из имён через точку, например `link.crank.mass`
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
scene-far-longer = Звено `{ $link }` имеет длину { $length }, остальные — около { $others }: верна ли единица?
scene-great-inertia = Момент инерции звена `{ $link }` имеет радиус инерции { $radius }, а размер механизма { $size }: верна ли единица?
scene-far-center = Центр масс звена `{ $link }` лежит в { $distance } от его точек, а размер механизма { $size }: верна ли единица?
scene-long-links = Большинство звеньев имеет длину около { $length }: не пропущена ли единица? Число без единицы — в м.
scene-friction-short-contact = должно быть не менее 0,001 мм, а есть { $got }; без него ползун прижат в одном месте
