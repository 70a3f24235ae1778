# Назви навантажень, яких сцена не називає.
scene-unnamed-force = сила { $number } на ланці { $link }
scene-unnamed-moment = момент { $number } на ланці { $link }
scene-unnamed-brake = гальмо { $number } на ланці { $link }
scene-unnamed-spring = пружина { $number }
scene-unnamed-contact = контакт { $number } на ланці { $link }

# Помилки сцени: що не так, виправлення поруч і що дозволено.
scene-more-faults = ... і ще { $more }
scene-fault = помилка: { $message }
scene-place = { $file }, рядок { $line }, стовпець { $column }
scene-did-you-mean = можливо, `{ $name }`?
scene-did-you-mean-letters = можливо, `{ $name }`? вигляд однаковий, але є літери іншої абетки: { $codes }
scene-such-as = наприклад { $example }
scene-and-more = { $names } і ще { $more }
scene-key = ключ
scene-knows = { $what } — відомі ключі: { $keys }
scene-add-key = додайте `{ $key } = ...`
scene-needs-key = { $what } — потрібен ключ `{ $key }`
scene-problem-of-key = `{ $key }`: { $problem }
scene-wants = потрібно: { $wanted }; задано: { $got }
scene-unknown = невідомо: { $what } `{ $name }`
scene-write-once = напишіть [{ $key }] один раз
scene-one-table = одна таблиця
scene-list-of-tables = список таблиць
scene-write-list = напишіть [[{ $key }]]
scene-list-of-so-many = список з { $count ->
    [one] { $count } елемента
   *[other] { $count } елементів
 }
scene-in-quotes = у лапках
scene-an-empty-text = порожній текст
scene-an-invisible-text = текст із невидимими знаками
scene-a-text = текст
scene-one-of = одне з: { $words }
scene-true-or-false = так чи ні (true, false)
scene-an-integer = ціле число
scene-a-number = число
scene-a-boolean = логічне значення
scene-a-date = дата
scene-a-list = список
scene-a-table = таблиця
scene-limit-not-negative = не від'ємне
scene-limit-positive = більше за 0
scene-limit-direction = щонайбільше 1000 обертів
scene-negative = не може бути від'ємним; задано: { $got }
scene-not-positive = має бути більше за 0; задано: { $got }
scene-many-turns = напрям, щонайбільше 1000 обертів; задано: { $got }
scene-without-quotes = для { $unit } пишіть без лапок
scene-no-unit = немає одиниці: { $got }
scene-no-digits = у результатах не лишилося б вірних цифр: чи правильна одиниця?
scene-a-finite-number = скінченне число
scene-refused-numbers = `nan`, `inf` і числа понад 1.8e308 не приймаються
scene-a-whole-number = ціле число від { $least } до { $most }
scene-such-as-or-in = наприклад { $example } або число в { $unit }
scene-got-no-number = `{ $text }` — на початку немає числа
scene-comma = кома в числі `{ $number }`: десятковий знак — крапка
scene-too-large = завелике: `{ $text }`, щонайбільше { $most }
scene-too-small = замале: `{ $text }`, щонайменше { $least } або 0
scene-got-unknown-unit = невідома одиниця `{ $unit }`
scene-got-unit = `{ $unit }`, { $measures }
scene-no-quantity = такої величини в сцені немає
scene-dimension-plain-number = число без одиниці
scene-dimension-length = довжина
scene-dimension-angle = кут
scene-dimension-mass = маса
scene-dimension-time = час
scene-dimension-force = сила
scene-dimension-moment = момент сили
scene-dimension-speed = швидкість
scene-dimension-rotation = кутова швидкість
scene-dimension-acceleration = прискорення
scene-dimension-angular-acceleration = кутове прискорення
scene-dimension-inertia = момент інерції
scene-dimension-stiffness = жорсткість
scene-dimension-damping = коефіцієнт опору
scene-dimension-power = потужність
scene-with-units = { $quantity } ({ $units })
scene-a-scene = сцена
scene-file-too-large = { $what } — щонайбільше { $most } МіБ, тут { $size }
scene-many-tables = { $what } — щонайбільше { $most } таблиць і списків, тут їх більше
scene-right-file = чи той це файл?
scene-unclosed = не TOML: текст не закрито лапкою
scene-begins-here = він починається тут
scene-duplicate-key = не TOML: ключ `{ $key }` повторюється
scene-stands-already = вона вже є в рядку { $line }: усі її ключі пишуть там
scene-no-quotes = число пишуть без лапок
scene-unquoted-key = не TOML: { $message }; ім'я з іншими знаками має бути в лапках
scene-no-toml = не TOML: { $message }
scene-long-name = у `{ $name }` знаків { $count }, читається щонайбільше { $most }
scene-take-shorter = візьміть коротше ім'я
scene-many-points = точок на ланках у сцені може бути щонайбільше { $most }, а тут { $count }
scene-many-loads = навантажень у сцені може бути щонайбільше { $most }, а тут { $count }
scene-many-slides = поступальних пар у сцені може бути щонайбільше { $most }, а тут { $count }
scene-many-links = ланок у сцені може бути щонайбільше { $most }, а тут { $count }
scene-one-too-many = перше зайве
scene-the-ground = стояк
scene-tables-of-links = таблиці [link.ІМ'Я]
scene-write-link = напишіть [link.crank]
scene-add-links = додайте рухомі ланки: [link.crank], [link.rod] ...
scene-no-length = у ланки `{ $link }` шарніри { $pins } в одній точці: її довжина нульова
scene-give-length = задайте для них різні координати або з'єднайте сусідні ланки одним шарніром
scene-inertia-of-others = формула моменту інерції залежить від { $variables }
scene-inertia-of-q = він може залежати лише від `q`, вхідної координати
scene-inertia-not-smooth = через `{ $function }` момент інерції має стрибок або злам
scene-inertia-smooth = його похідна входить до рівняння руху: вживайте гладкі функції
scene-inertia-not-pinned = момент інерції ланки `{ $link }` змінний, але жоден шарнір не з'єднує її зі стояком
scene-inertia-of-a-number = задайте число або з'єднайте ланку зі стояком шарніром
scene-inertia-not-positive = `inertia` дорівнює { $value } kg*m^2 за q = { $at }
scene-inertia-positive = момент інерції має бути додатним і не більшим за { $most } всюди, де проходить вхідна ланка
scene-no-link-name = `{ $name }` не може бути ім'ям ланки
scene-no-point-name = `{ $name }` не може бути ім'ям точки
scene-what-is-a-name = ім'я не може бути порожнім, містити крапку чи невидимі знаки
scene-ground-as-link = стояк не є рухомою ланкою
scene-points-of-ground = його точки пишуть у [ground]
scene-link-moment = ланка не може мати ім'я `moment`
scene-results-use-it = його вжито в результатах: виберіть інше
scene-a-link = ланка
scene-table-of-points = таблиця точок
scene-why-a-center = потрібен ланці з масою чи моментом інерції, якщо в неї не одна точка
scene-a-slide = поступальна пара
scene-swap-slide = хай рухома ланка ковзає по "ground"
scene-slide-on-itself = ланка `{ $link }` не може ковзати сама по собі
scene-another-link = інша ланка або "ground"
scene-a-name = ім'я
scene-pin-and-slide = шарнір і поступальна пара мають те саме ім'я `{ $name }`
scene-two-slides = дві поступальні пари мають те саме ім'я `{ $name }`
scene-own-name = дайте цій власне ім'я ключем `name`
scene-name-of-a-link = ім'я ланки
scene-a-moving-link = рухома ланка
scene-name-of-a-point = ім'я точки
scene-none-of-them = у сцені немає { $what ->
    [link] ланок
    [point] точок
    [slide] поступальних пар
   *[pair] шарнірів і поступальних пар
 }
scene-all-of-them = { $what ->
    [link] ланки
    [point] точки
    [slide] поступальні пари
   *[pair] шарніри й поступальні пари
 }: { $names }
scene-no-such-part = `{ $key }`: немає { $what ->
    [link] ланки
    [point] точки
    [slide] поступальної пари
   *[pair] шарніра чи поступальної пари
 } `{ $name }`
scene-point-or-place = точка або [x, y]
scene-no-point-on-link = `{ $key }`: на ланці `{ $link }` немає точки `{ $point }`
scene-point-elsewhere = `{ $key }`: точка `{ $point }` не на ланці `{ $link }`, вона належить: { $holders }
scene-link-without-points = на ній немає точок: задайте [x, y]
scene-points-of-link = її точки: { $points }
scene-coordinates = [x, y] або довжина на осі x
scene-such-coordinates = наприклад [0, "-400 mm"] або "120 mm"
scene-two-lengths = дві довжини, наприклад ["60 mm", "70 mm"]
scene-place-of-a-point = місце точки
scene-why-a-place = `r` і `angle` або `from` і `lengths`
scene-circle-of-points = місце точки `{ $point }` залежить від неї самої: { $way }
scene-one-by-coordinates = задайте одну з цих точок як [x, y]
scene-triangle-one-place = точка `{ $point }` не має місця: `{ $one }` і `{ $other }` збігаються
scene-triangle-other-points = візьміть дві різні точки або задайте [x, y]
scene-triangle-short = трикутник точки `{ $point }` не замикається на { $gap }: між `{ $one }` і `{ $other }` { $apart }, більше за обидві довжини разом
scene-triangle-lengthen = подовжте їх разом на { $gap } або зблизьте точки
scene-triangle-long = трикутник точки `{ $point }` не замикається на { $gap }: між `{ $one }` і `{ $other }` { $apart }, менше за різницю довжин
scene-triangle-shorten = скоротіть довшу або подовжте коротшу на { $gap }, або розсуньте точки
scene-needs-motion = { $what }: потрібен рух, а в сцені немає [motion]
scene-add-motion = додайте [motion] зі `speed`
scene-two-loads = два навантаження мають те саме ім'я `{ $name }`
scene-gravity-upward = `gravity` одним числом напрямлена вниз і не може бути від'ємною
scene-or-both-components = або [gx, gy]
scene-a-force = сила
scene-a-moment = момент
scene-a-brake = гальмо
scene-ground-carries = стояк несе будь-яке навантаження
scene-exclude = `{ $one }` і `{ $other }` несумісні
scene-leave-one-out = приберіть одне з них
scene-why-an-angle = напрям: `angle` або `against_motion = true`
scene-ground-does-not-turn = стояк не обертається
scene-a-spring = пружина
scene-a-contact = контакт
scene-two-points = дві точки, наприклад ["C", "D"]
scene-both-ends-on-link = обидва кінці на ланці `{ $link }`
scene-such-a-spring = така пружина не змінює довжини; задайте точки двох різних ланок
scene-point-of-link = точка або "ланка.точка"
scene-not-on-link = точка `{ $point }` не на ланці `{ $link }`
scene-belongs-to = вона належить: { $holders }
scene-arc-of-a-link = пряма належить стояку, дуга — ланці
scene-during-backward = `during` закінчується раніше, ніж починається
scene-during-nothing = `during` має рівні кінці: контакт ніколи не діє
scene-from-less-than-to = [from, to], де `from` менше за `to`
scene-add-input = додайте [input] з `link` — ланкою, що рухає інші
scene-the-input = вхідна ланка
scene-link-joined-to-ground = ланка, з'єднана зі стояком
scene-input-not-joined = вхідна ланка `{ $link }` не з'єднана зі стояком
scene-join-the-input = точка, яка є і в [ground], або [[slide]] на "ground"
scene-input-joined-often = вхідна ланка `{ $link }` з'єднана зі стояком { $count ->
    [one] { $count } раз
    [few] { $count } рази
   *[other] { $count } разів
 }: { $pairs }
scene-one-pair-of-input = там має бути рівно один шарнір або одна поступальна пара
scene-why-an-input = одне з `link`, `slide` і `pin` каже, що рухає
scene-of-a-pin = це належить до ведучого шарніра `pin`
scene-ends-of-pin = `{ $pin }` не з'єднує `{ $of }` і `{ $on }`
scene-pin-joins = він з'єднує: { $links }
scene-ground-is-on = стояк — це те, відносно чого рухають ланку
scene-swap-of-and-on = поміняйте місцями `of` і `on`
scene-which-on = `{ $pin }` з'єднує більше двох ланок
scene-no-motor-between = `{ $key }` потребує ланки, яку рухають відносно стояка
scene-torque-between = задайте `torque`: навантаження приводу між обома ланками
scene-cycle-or-range = або цілий цикл, або проміжок
scene-no-range = `to` дорівнює `from`, а `positions` = { $positions }
scene-one-position-or-another-end = positions = 1 або інший кінець
scene-why-to = поступальний вхід не має власного циклу: задайте `to` або `cycle`
scene-an-input = вхід
scene-law-over-time = закон за часом
scene-needs-one-input = { $what }: потрібен один вхід, а зі списком входів координатою є час
scene-law-prescribes = { $what }: не потрібно поряд з `over_time`, який задає рух
scene-not-over-coordinate = { $what }: потрібен вхід без `over_time`, бо з ним координатою є час
scene-over-time-instead = задайте за часом: таблицею з `over = "time"` або формулою від `t`
scene-formula-of = формула від { $variables }
scene-add-motion-until = додайте [motion] з `until` — часом, коли рух закінчується
scene-why-until = час, коли рух закінчується
scene-why-a-law = таблиця рядків [час, координата] або формула від часу `t`
scene-not-from-zero = починається з часу 0, а перший рядок має { $got }
scene-single-row = потрібні щонайменше два рядки
scene-times-repeat = час у рядках має зростати
scene-law-without-jumps = координата не може стрибати: приберіть рядок або дайте йому пізніший час
scene-until-beyond = `until` дорівнює { $until }, а останній рядок має { $last }
scene-longer-or-closed = додайте рядки або закінчіть рух там; повторюється лише таблиця, що закінчується першим значенням
scene-law-of-others = формула закону за часом залежить від { $variables }
scene-law-of-t = вона може залежати лише від `t`, часу в секундах
scene-law-without-value = закон має нескінченну або надмірну координату, швидкість чи прискорення при { $at }
scene-law-within-limits = він має діяти від 0 до `until`
scene-driven-twice = два входи рухають пару { $pair } тих самих ланок
scene-the-motion = рух
scene-other-motion = `{ $key }` належить до руху виду "{ $owner }", а цей — "{ $kind }"
scene-motion-knows = рух виду "{ $kind }" — відомі ключі: { $keys }
scene-name-of-integrator = назва методу інтегрування
scene-large-tolerance = `tolerance` — відносний допуск, менший за 1; задано: { $got }
scene-time-or-travel = { $time } або { $travel }
scene-end-of-motion = { $time }, { $travel }, "rest" або "turn"
scene-many-samples = `samples` може бути щонайбільше { $most }: у сцені ланок, точок, поступальних пар і навантажень разом { $parts }
scene-kept-in-memory = їхні числа зберігаються в пам'яті
scene-steady-without-cycle = усталеному руху потрібен цикл, а вхідна ланка рухається в проміжку
scene-give-a-cycle = задайте вхідній ланці `cycle`
scene-large-unevenness = `unevenness` — це (найбільша − найменша) / середня швидкість, менше за 2; задано: { $got }
scene-leave-it-out = приберіть
scene-the-balance = зрівноваження
scene-why-at-and-angle = сила має `at` і `angle`, момент — жодного з них
scene-the-output = вивід
scene-list-of-names = список імен
scene-ground-does-not-move = стояк нерухомий
scene-name-of-a-slide = ім'я поступальної пари
scene-name-of-a-pair = ім'я шарніра чи поступальної пари
scene-pins = шарніри: { $pins }
scene-point-is-no-pin = точка `{ $point }` не шарнір: вона належить лише одній ланці
scene-the-note = записка
scene-list-of-positions = список номерів положень
scene-here-are = тут { $count }
scene-the-drive = привод
scene-large-efficiency = `efficiency` більший за 0 і щонайбільше 1; задано: { $got }
scene-drive-without-motion = [drive] потребує руху виду "transient" або "steady", а в сцені руху немає
scene-drive-of-prescribed = [drive] потребує руху виду "transient" або "steady", а цей — "prescribed"
scene-kept-by-balance = заданий рух підтримує зрівноважувальне навантаження
scene-key-of-motor = `{ $key }` стосується двигуна, а у приводу його немає
scene-add-motor = додайте `motor = ...` або приберіть
scene-flywheel-on-no-motor = маховик на двигуні, а у приводу двигуна немає
scene-no-flywheel = `flywheel_on` без `flywheel`
scene-add-flywheel = додайте `flywheel = "solve"` або момент інерції
scene-input-slides = `{ $key }` потребує обертальної вхідної ланки, а ця поступальна
scene-solve-needs-steady = `{ $key } = "solve"` потребує руху виду "steady"
scene-number-for-transient = для неусталеного руху задайте число
scene-flywheel-needs-unevenness = `flywheel = "solve"` потребує `unevenness` у [motion]
scene-unevenness-needs-motor = `unevenness = "motor"` потребує [drive] із двигуном і `flywheel = "solve"`
scene-word-or = "{ $word }" або { $quantity }
scene-empty-drive = `motor`, `torque` або `flywheel`: порожній привод нічого не робить
scene-name-of-catalogue = назва каталогу
scene-kloss-needs-ratio = `characteristic = "kloss"` потребує `max_torque_ratio`
scene-or-linear = або characteristic = "linear"
scene-key-of-catalogue = `{ $key }` стосується двигуна з каталогу, а цей задано його даними
scene-designation = позначення, "auto" або номінальні дані
scene-a-motor = двигун
scene-no-slip = `rated_speed` має бути менша за `synchronous_speed`
scene-motor-slips = асинхронний двигун має ковзання
scene-small-torque-ratio = `max_torque_ratio` має бути більше за 1; задано: { $got }
scene-breakdown-by-rated = критичний момент / номінальний момент
scene-a-formula = формула
scene-table-over-angle = таблиця за кутом
scene-table-over-time-or-speed = таблиця за часом або швидкістю
scene-table-over-stroke = таблиця за ходом
scene-stroke-of-a-force = хід має лише точка прикладання сили
scene-other-arguments = over = "angle" (або "coordinate"), "time" або "speed"
scene-scale-out-of-range = через `scale` величина навантаження { $size } поза межами
scene-right-unit-and-factor = у результатах не лишилося б вірних цифр: чи правильні одиниця та множник?
scene-table-of-a-load = таблиця навантаження
scene-all-arguments = over = "angle" (або "coordinate"), "time", "speed" або "stroke"
scene-a-unit = одиниця
scene-formula-of-motion = формула з `w` чи `t`
scene-axis-without-x = `axis` зайвий: у формулі немає `x`
scene-x-along-axis = `x` — положення точки вздовж `axis`
scene-x-of-a-force = положення `x` має лише точка прикладання сили
scene-use-other-variables = вживайте `q`, `w` або `t`
scene-repeat-without-cycle = `repeat` потребує циклу, а вхідна ланка рухається в проміжку
scene-long-table = таблиця охоплює { $span }, а цикл має { $cycle }
scene-shorten-table = `repeat = false`, довший `cycle` вхідної ланки або менше рядків
scene-forward-or-back = `forward`, `back` або обидва
scene-row-outside-stroke = є рядок за { $at }, а хід триває від 0 до 1
scene-list-of-rows = список рядків
scene-no-rows = немає рядків
scene-many-rows = рядків { $count }, читається щонайбільше { $most }
scene-leave-rows-out = приберіть частину рядків: між ними проводяться прямі
scene-rows-decrease = перші числа рядків не можуть спадати
scene-smaller-than-before = менше, ніж у попередньому рядку
scene-rows-of-two = рядки з двох чисел
scene-no-list = `{ $key }` — не список
scene-single-value = `{ $key }` — одне значення без частин
scene-table-is-no-list = { $owner } — не список; там є: { $names }
scene-no-elements = { $owner } — елементів немає
scene-elements = { $owner } — елементів { $count }, від [0] до [{ $last }]
scene-list-without-names = { $owner } — список без імен: назвіть елемент номером, наприклад `{ $list }[0]`
scene-or-by-number = { $problem }, або назвіть елемент номером, наприклад `{ $list }[0]`
scene-several-values = `{ $key }` — кілька значень
scene-is-a-table = `{ $key }` — таблиця; там є: { $names }
scene-is-a-list = `{ $key }` — список; там є: { $names }
scene-is-a-boolean = `{ $key }` — логічне значення, а не число
scene-is-a-date = `{ $key }` — дата, а не число
scene-the-scene = сцена
scene-default-not-written = значення за умовчанням треба записати в сцені, щоб його змінювати
scene-owner-has-no = { $owner }: немає `{ $name }`; { $hint }; там є: { $names }
scene-nothing = нічого
scene-angle-of-sliding = тертя задано як `against_sliding`, а `angle` залежить не лише від координати вхідної ланки
scene-law-over-coordinate = число або таблиця чи формула за координатою вхідної ланки
scene-friction-against-sliding = тертя проти ковзання

## friction in pairs
scene-a-friction = тертя
scene-friction-in-free-motion = із сухим тертям у парах рух, що випливає з рівняння руху, створює привод вхідної ланки: іншого зрівноважувального навантаження він не має
scene-friction-prescribed = приберіть `[balance]` або задайте рух (`kind = "prescribed"`)
scene-friction-twice = тертя пари { $pair } вже задано
scene-friction-of-slides = `{ $key }` належить до тертя поступальної пари, а ця пара обертальна
scene-friction-of-pins = `{ $key }` належить до тертя обертальної пари, а ця пара поступальна
scene-friction-owner = ланку `{ $link }` цей шарнір не з’єднує
scene-friction-without-length = `{ $key }` потребує довжини контакту
scene-friction-add-length = додайте `length` або вилучіть цей ключ
scene-hardly-meant = `{ $key }` = { $number } узято в { $unit }, тобто { $is }; якщо мали на увазі інше, напишіть { $instead }.
scene-formula-as-number = — формула на місці числа: { $text }
scene-same-appearance = Точка `{ $name }` ({ $codes }) має вигляд точки `{ $other }`, але містить літери іншої абетки: це дві різні точки.
scene-negative-length = Точку `{ $point }` задано одним від'ємним числом, тобто координатою x: ланку повернуто навпаки, і її кут інший на 180°. Довжина додатна: напишіть { $length } або { $place }, якщо мали на увазі координату.
scene-far-longer = Ланка `{ $link }` має довжину { $length }, інші — близько { $others }: чи правильна одиниця?
scene-great-inertia = Момент інерції ланки `{ $link }` має радіус інерції { $radius }, а розмір механізму { $size }: чи правильна одиниця?
scene-far-center = Центр мас ланки `{ $link }` лежить за { $distance } від її точок, а розмір механізму { $size }: чи правильна одиниця?
scene-long-links = Більшість ланок має довжину близько { $length }: чи не бракує одиниці? Число без одиниці — у м.
scene-friction-short-contact = має бути щонайменше 0,001 мм, а є { $got }; без нього повзун притиснуто в одній точці

## the reference of the keys
scene-either = { $these } або { $last }
scene-kind-by-input = { $turning }, якщо вхідна ланка обертається, { $sliding }, якщо вона ковзає
scene-kind-count = ціле число
scene-kind-name = назва { $what ->
    [link] ланки
    [point] точки
    [slide] поступальної пари
    [pair] шарніра або поступальної пари
    [motor] двигуна
   *[plugin] плагіна
 }
scene-kind-place = точка ланки, [x, y] у її системі або довжина на її осі x
scene-kind-two = список із двох: { $of }
scene-kind-list = список: { $of }
scene-kind-table = таблиця: { $header }
scene-the-assembly = складання
scene-key-elsewhere = його місце в { $tables }
scene-key-title = Назва для заголовків і рисунків.
scene-key-gravity = Прискорення вільного падіння: одне число спрямоване вниз, два є складовими; без нього ланки не мають ваги.
scene-key-ground = Стояк, ланка 0, з нерухомими точками.
scene-key-link = Рухомі ланки; назва точки, вжита у двох ланках, є шарніром між ними.
scene-key-slide = Поступальні пари: одна ланка ковзає по іншій уздовж прямої.
scene-key-input = Вхідна ланка, її координата й положення, що обчислюються; або список входів [[input]], кожен за часом.
scene-key-assembly = Приблизно де є точки в першому положенні: за ним вибирається варіант складання груп.
scene-key-force = Сила в точці ланки.
scene-key-moment = Момент на ланку, додатний проти годинникової стрілки.
scene-key-spring = Пружина, демпфер або обидва між точками двох ланок.
scene-key-contact = Дуга ланки, що котиться й ковзає по прямій стояка.
scene-key-friction = Сухе тертя в шарнірі або в поступальній парі; без нього пара ідеальна.
scene-key-brake = Колодка, притиснута до диска: момент проти руху ланки.
scene-key-balance = Навантаження, що підтримує заданий рух; без нього воно діє на вхідну ланку.
scene-key-motion = Як рухається вхідна ланка; без цього обчислюються передавальні функції, а за навантажень — статика.
scene-key-drive = Двигун, редуктор і маховик, для неусталеного або усталеного руху.
scene-key-output = Обчислюється лише це; без цього все, що сцена дозволяє.
scene-key-note = Титульна сторінка й мова `assur report`.
scene-key-points-of-ground = Точки стояка за назвами: [x, y], одне число на осі x або таблиця: полярні координати або відстані від двох точок.
scene-key-points = Точки за назвами у власній системі ланки, початок і вісь x якої ви вибираєте: [x, y], одне число на осі x або таблиця: полярні координати або відстані від двох точок. Назва у двох ланках є шарніром; довжини ланок є відстанями між їхніми точками.
scene-key-place-r = Відстань від початку системи ланки або від точки `about`.
scene-key-place-angle = Напрям від осі x ланки, проти годинникової стрілки.
scene-key-place-about = Точка тієї ж ланки, від якої відміряно `r`; якщо її немає — початок системи ланки.
scene-key-place-from = Дві точки тієї ж ланки, від яких точка має відстані `lengths`.
scene-key-place-lengths = Відстані від двох точок `from` у їхньому порядку.
scene-key-place-side = З якого боку лінії від першої точки до другої лежить точка, якщо дивитися вздовж лінії.
scene-key-mass = Маса ланки; без неї ланка невагома.
scene-key-center = Центр мас; можна не вказувати, якщо ланка має одну точку.
scene-key-inertia = Момент інерції відносно центра мас; для ланки, з'єднаної шарніром зі стояком, також формула від вхідної координати.
scene-key-slide-link = Ланка, що ковзає.
scene-key-slide-on = Ланка, що несе напрямну, або "ground".
scene-key-slide-through = Точка напрямної прямої в системі ланки, що її несе; без неї початок цієї системи.
scene-key-slide-angle = Напрям напрямної прямої в системі ланки, що її несе.
scene-key-slide-point = Точка повзуна, що лишається на напрямній прямій; без неї його перша точка.
scene-key-slide-tilt = Кут осі x повзуна від напряму напрямної.
scene-key-slide-name = Її назва в результатах; без неї link/on.
scene-key-input-link = Вхідна ланка: з'єднана шарніром зі стояком або ковзає по ньому.
scene-key-input-slide = Замість `link`: повзун, що рухає; між двома рухомими ланками — циліндр; координата — його переміщення.
scene-key-input-pin = Замість `link`: шарнір, що рухає, — двигун у з'єднанні двох ланок; координата — кут осі x ланки `of` мінус кут осі x ланки `on`.
scene-key-input-of = Ланка, яку повертає ведучий шарнір.
scene-key-input-on = Ланка, відносно якої ведучий шарнір повертає `of`; потрібна, де шарнір з'єднує більше двох ланок.
scene-key-input-from = Координата першого положення: кут осі x ланки або переміщення її повзуна.
scene-key-input-positions = Скільки положень обчислюється: рівномірно за цикл, без повторення його кінця.
scene-key-input-cycle = Хід вхідної ланки, після якого все повторюється; без нього один оберт.
scene-key-input-direction = Напрям зміни координати: "ccw" зростає, "cw" спадає.
scene-key-input-to = Координата останнього положення замість циклу; вхідному повзуну потрібна вона або цикл.
scene-key-input-name = Як координата зветься на осях і в таблицях; без неї "координата" і вхідна ланка.
scene-key-input-over-time = Координата за часом, замість `from` і того, що її рухає: [motion] тоді має лише `until` і `samples`.
scene-key-inputs-from = Координата при часі 0: кут осі x ланки або переміщення її повзуна.
scene-key-input-rate = На скільки координата зростає за секунду, зі знаком; без [motion] не використовується.
scene-key-time-table = Рядки [час, координата], перший при часі 0, час зростає; таблиця, що закінчується першим значенням, повторюється.
scene-key-time-shape = Рядки з'єднано відрізками, між якими швидкість стрибає, або кубічним сплайном: природним, а де перше значення дорівнює останньому — періодичним.
scene-key-time-formula = Формула лише від t (час, с), у рад або м; швидкість і прискорення — її похідні.
scene-key-assembly-point = Точка механізму й приблизно де вона є в першому положенні.
scene-key-load-name = Його назва в результатах і в ключах.
scene-key-load-link = Ланка, на яку воно діє.
scene-key-scale = Множник величини навантаження, який можна варіювати.
scene-key-force-at = Точка ланки, у якій діє сила.
scene-key-force-angle = Напрям сили, проти годинникової стрілки від осі x; сила опору спрямована проти руху.
scene-key-force-frame = У чиїй системі відлічується кут: стояка чи ланки.
scene-key-value = Його величина: число, таблиця від кута, часу, швидкості або ходу чи формула.
scene-key-against-motion = Замість кута: сила завжди протилежна швидкості своєї точки.
scene-key-moment-against = Момент завжди протилежний обертанню своєї ланки; його значення — опір за будь-якого напряму обертання.
scene-key-spring-between = Два її кінці: точки двох ланок, записані "link.point", якщо назви замало.
scene-key-spring-stiffness = Жорсткість пружини.
scene-key-spring-length = Вільна довжина пружини.
scene-key-spring-damping = Демпфування вздовж лінії між кінцями.
scene-key-contact-center = Центр дуги.
scene-key-contact-radius = Радіус дуги.
scene-key-contact-angle = Де на дузі діє сила, від її найнижчої точки за годинниковою стрілкою.
scene-key-contact-force = Сила на дугу, до її центра.
scene-key-contact-friction = Коефіцієнт тертя зі знаком або таблиця, знак у якій випливає з ковзання.
scene-key-contact-during = Інтервал вхідної координати, у якому є контакт; без нього завжди.
scene-key-against-sliding = Коефіцієнт тертя проти ковзання.
scene-key-brake-radius = Радіус диска.
scene-key-brake-force = Сила на важелі.
scene-key-brake-lever = У скільки разів важіль збільшує силу.
scene-key-brake-friction = Коефіцієнт тертя між колодкою й диском.
scene-key-over = Від чого залежить величина: від вхідної координати, часу, вхідної швидкості чи ходу точки сили.
scene-key-table = Рядки [аргумент, величина] за зростанням; два рядки з одним аргументом дають стрибок.
scene-key-shape = Рядки з'єднані прямими, або кожна величина діє до наступного рядка.
scene-key-repeat = Чи повторюється таблиця від кута з циклом; без цього повторюється, якщо цикл є.
scene-key-axis = Напрям, уздовж якого вимірюється хід точки.
scene-key-forward = Величина, поки точка рухається вздовж осі: число або рядки від її місця від 0 до 1.
scene-key-back = Величина, поки точка повертається: число або рядки від її місця вздовж осі, від 0 до 1, як у `forward`.
scene-key-formula = Формула від q (координата, рад або м), w (швидкість, додатна вздовж `direction`: опір входові — -5*w, де він обертається проти годинникової стрілки, 5*w, де за нею), t (час), x (місце точки вздовж осі, від 0 до 1) в SI, із sin cos tan asin acos atan atan2 sqrt exp ln abs sign min max step pi; кути в радіанах.
scene-key-inertia-formula = Гладка формула від q, вхідної координати, додатна всюди, куди потрапляє вхідна ланка.
scene-key-unit = Одиниця результату формули; без неї SI.
scene-key-friction-pair = Шарнір або поступальна пара, в якій діє тертя.
scene-key-friction-coefficient = Коефіцієнт тертя.
scene-key-friction-radius = Радіус цапфи.
scene-key-friction-owner = Ланка, якій належить цапфа; без неї стояк, інакше перша ланка шарніра в порядку файлу.
scene-key-friction-length = Довжина контакту вздовж напрямної: сила й момент тиснуть на її кінці; без неї тиск в одній точці.
scene-key-friction-middle = Із чим рухається середина контакту: з точкою повзуна чи з напрямною.
scene-key-friction-offset = Відстань поверхонь ковзання від напрямної прямої, з обох боків; потрібна довжина.
scene-key-balance-link = Ланка, на яку діє зрівноважувальне навантаження.
scene-key-balance-at = Точка зрівноважувальної сили; без неї діє момент.
scene-key-balance-angle = Напрям зрівноважувальної сили.
scene-key-motion-kind = Заданий: швидкість і прискорення дано; неусталений: випливає з навантажень і приводу; усталений: періодичний режим.
scene-key-motion-speed = Швидкість вхідної ланки вздовж її напряму в першому положенні; заданому руху вона потрібна, неусталений без неї починається зі спокою.
scene-key-motion-acceleration = Прискорення вхідної ланки вздовж її напряму.
scene-key-motion-until = Кінець: час, хід вхідної ланки, "rest" (остаточна зупинка) чи "turn" (перший реверс); руху за часом — час.
scene-key-motion-samples = Скільки рівновіддалених моментів після першого наводиться.
scene-key-motion-integrator = Зареєстрований метод (`assur plugins`); "auto" вибирає його.
scene-key-motion-tolerance = Відносний допуск інтегрування.
scene-key-motion-step = Крок методів зі сталим кроком: час або хід вхідної ланки.
scene-key-motion-max-steps = Після стількох кроків інтегрування припиняється.
scene-key-motion-mean-speed = Середнє найбільшої та найменшої швидкості вхідної ланки.
scene-key-motion-unevenness = (max - min) / mean вхідної швидкості, 0.05 або "1/20"; "motor": найбільша, за якої двигун лишається на робочій ділянці.
scene-key-drive-motor = Позначення з каталогу, "auto" для найменшого придатного або номінальні дані.
scene-key-drive-catalogue = Каталог, у якому шукається двигун (`assur plugins`).
scene-key-drive-max-motor-speed = Найбільша синхронна швидкість двигуна, який бере "auto".
scene-key-drive-characteristic = Момент від швидкості: за формулою Клосса або пряма робоча ділянка.
scene-key-drive-ratio = Швидкість двигуна до вхідної швидкості; "solve" знаходить його.
scene-key-drive-efficiency = ККД редуктора.
scene-key-drive-torque = Замість двигуна: сталий момент (для вхідного повзуна сила) вздовж напряму; "balance" робить роботу за цикл нульовою.
scene-key-drive-flywheel = Момент інерції маховика; "solve" знаходить його за нерівномірністю.
scene-key-drive-flywheel-on = Вал, що несе маховик.
scene-key-motor-power = Номінальна потужність.
scene-key-motor-synchronous-speed = Синхронна швидкість.
scene-key-motor-rated-speed = Номінальна швидкість, менша за синхронну.
scene-key-motor-max-torque-ratio = Критичний момент до номінального; потрібен для "kloss".
scene-key-motor-inertia = Момент інерції ротора.
scene-key-output-names = Назви того, що обчислюється; групи, від яких ніщо з цього не залежить, не розв'язуються.
scene-key-note-author = Хто виконав.
scene-key-note-group = Група автора.
scene-key-note-variant = Варіант завдання.
scene-key-note-language = Мова записки, креслень і текстів.
scene-key-note-positions = Номери положень, що кресляться й розписуються; без них вибирає програма.
scene-key-of-sorts = він належить до іншого виду: { $sorts }

## what is hardly meant in loads and motion
scene-typographic-quotes = це лапки текстового процесора: пишіть " перед і після
scene-unquoted-quantity = число з одиницею пишеться в лапках: "{ $value }"
scene-decimal-comma = кома тут — десятковий роздільник? ним має бути крапка
scene-small-inertia = Момент інерції ланки `{ $link }` має радіус інерції { $radius }, а довжина ланки { $size }: чи не хибна одиниця?
scene-far-heavier = Ланка `{ $link }` має масу { $mass }, інші приблизно { $others }: чи не хибна одиниця?
scene-odd-gravity = Прискорення вільного падіння { $size }; на Землі воно 9.81 m/s^2. Пишіть "9.81 m/s^2" або вилучіть `gravity`.
scene-fast = Ланки рухалися б зі швидкістю { $speed } і більше, якої не витримує жоден матеріал: швидкість в іншій одиниці?
scene-rough = Коефіцієнт тертя { $found } не має жодна пара твердих тіл; чи не у відсотках він?
scene-great-journal = Цапфа має радіус { $radius }, а розмір механізму { $size }: чи не хибна одиниця?
scene-empty-output = [output] нічого не називає, тому нічого не обчислюється: назвіть точки, ланки, поступальні пари чи реакції або вилучіть її.
scene-long-spring = Пружина має вільну довжину { $length }, а розмір механізму { $size }: чи не хибна одиниця?
scene-spring-without-stiffness = Пружина не має ні `stiffness`, ні `damping`, тож не має сили: чи не бракує жорсткості?
scene-strong = Навантаження відповідає силі { $force } на механізм розміром { $size }, якої не витримає жодна сталь: чи не хибна одиниця?
scene-long-time = Таблиця від часу сягає { $last }, а рух триває { $lasts }: час в іншій одиниці?
scene-drives-clockwise = Цей момент рухає вхід за будь-якої швидкості: `w` — швидкість уздовж `direction`, а момент додатний проти годинникової стрілки; опір входові, що обертається за годинниковою стрілкою, додатний: `5*w`.
scene-degrees-in-formula = `{ $function }` бере радіани, а тут її аргумент схожий на градуси: для 30 градусів пишіть 30*pi/180, а q вже в радіанах.
scene-negative-against = Від'ємне `value` проти руху рухає механізм: вилучіть мінус.
scene-key-at-top = він належить на початок файлу, перед першою [таблицею]
scene-comment-sign = не TOML: коментар починається з `#`
scene-colon = не TOML: ключ і його значення з'єднує `=`
scene-semicolon = не TOML: рядок закінчується без `;`
scene-round-brackets = не TOML: координати й списки пишуть у квадратних дужках: [x, y]
scene-invisible-sign = не TOML: тут є невидимий символ { $code }: замініть його пробілом
scene-missing-comma = не TOML: між двома значеннями бракує коми
scene-unclosed-brace = не TOML: цю фігурну дужку в її рядку не закрито
scene-missing-value = не TOML: тут бракує значення
scene-unquoted-text = не TOML: текст пишуть у лапках: "{ $value }"
scene-form-of-number = не TOML: напишіть число так: { $number }
scene-unclosed-header = не TOML: назва цієї таблиці не має закривної дужки
scene-key-without-value = не TOML: після ключа `{ $key }` мають стояти `=` і його значення
scene-example-or-word = { $example } або "{ $word }"
scene-grouped-digits = має пробіл у числі: `{ $text }`; пишіть його цифри разом
scene-degrees-in-table = число без одиниці - у радіанах: для градусів пишіть "360 deg"
scene-list-repeats = З `to` відстань між { $positions } положеннями дорівнює { $apart }, і останнє повторює перше: приберіть `to` або напишіть positions = { $more }.
scene-part-of-a-turn = Цикл { $cycle } не є цілим числом обертів: після нього механізм не повертається туди, де починав. Положення на частині оберту задають через `to`.
scene-gravity-up = Сила тяжіння напрямлена вгору: y зростає вгору. Напишіть "9.81 m/s^2" або [0, "-9.81 m/s^2"].
scene-inertia-without-mass = Ланка `{ $link }` не обертається навколо нерухомого шарніра й має момент інерції, але не має маси: чи не пропущено `mass`?
scene-mass-without-inertia = Ланка `{ $link }` обертається й має масу, але не має моменту інерції, який мають інші: його взято за 0; додайте `inertia` (0, якщо так і треба)
scene-far-lighter = Ланка `{ $link }` має масу { $mass }, інші - близько { $others }: чи не хибна одиниця?
scene-turned-twice = Від'ємна швидкість уздовж direction = "cw" - це обертання проти годинникової стрілки: приберіть мінус.
scene-odd-ratio = `ratio` - це швидкість двигуна / швидкість вхідної ланки; з { $ratio } двигун далеко від номінальної швидкості, її дало б { $needed }.
scene-great-torque-ratio = `max_torque_ratio` = { $found } - це критичний момент у { $found } разів більший за номінальний, а двигуни мають від 1.5 до 4; якщо це відсотки, напишіть { $part }.
scene-table-ends = Таблиця закінчується на { $last }, а цикл на { $end }: доти тримається { $held }, потім стрибок до { $first }. Якщо так і треба, напишіть `repeat = true`, інакше рядок для { $end }.
scene-unevenness-unused = `unevenness` нічого не змінює: з нього знаходять маховик, а його не шукають. Напишіть flywheel = "solve" у [drive] або приберіть його.
scene-counted-twice = { $point } стоїть під кутом { $angle } у системі координат вхідної ланки, а `from` повертає її ще на стільки ж: { $point } починає з { $twice }. Поставте { $point } на вісь x своєї ланки або приберіть `from`.
scene-the-sheet = аркуш
scene-list-of-fields = список полів
scene-many-positions-of-sheet = `{ $key }` аркуша має щонайбільше { $most } положень
scene-key-sheet = Формат, поля й основний напис `assur sheet`.
scene-key-sheet-format = Формат аркуша; без нього — найменший від A4 до A1, на якому вміщуються поля, а якщо й A1 замалий — кілька аркушів A1.
scene-key-sheet-positions = Положення, накреслені одне на одному: скільки їх за цикл або їхні номери.
scene-key-sheet-plans = Номери положень планів і багатокутників; без них — ті, що в записці.
scene-key-sheet-fields = Поля аркуша за порядком, з `mechanism`, `diagrams`, `velocities`, `accelerations`, `forces`, `lever`, `dynamics`, `results`; без ключа — ті, що є в сцені.
scene-key-sheet-number = Позначення креслення для основного напису.
scene-a-text-by-language = текст або таблиця мов
scene-text-by-language = текст за мовами
scene-an-empty-table = порожня таблиця
scene-table-of-labels = таблиця точок із підписами
scene-write-labels = наприклад { "[labels]" } із { "A = \"A₁\"" }
scene-columns-of-a-diagram = стовпці результатів через кому
scene-list-of-diagrams = список графіків
scene-list-of-chapters = список розділів
scene-many-of-note = `{ $key }` записки має щонайбільше { $most } елементів
scene-key-labels = Як читачі називають точки.
scene-key-labels-point = Як читачі називають цю точку; у файлах і ключах — її ім'я.
scene-key-label = Як це називають читачі, однією мовою чи кількома; у файлах і ключах — ім'я.
scene-key-language-en = Текст англійською.
scene-key-language-uk = Текст українською.
scene-key-language-ru = Текст російською.
scene-key-note-ministry = Міністерство, для титульної сторінки.
scene-key-note-university = Університет, для титульної сторінки.
scene-key-note-department = Кафедра, для титульної сторінки.
scene-key-note-discipline = Дисципліна, для титульної сторінки.
scene-key-note-supervisor = Керівник роботи.
scene-key-note-city = Місто, для титульної сторінки.
scene-key-note-year = Рік, для титульної сторінки.
scene-key-note-task = Текст завдання; порожній рядок розділяє абзаци.
scene-key-note-curves = Додаткові графіки: стовпці за заголовком, іменем у { "CSV" } чи словами; кілька через кому — один над одним.
scene-key-note-chapters = Розділи, які вона має, з { "results, task, structure, kinematics, forces, dynamics, energy, working, checks, model, sources, conclusions" }; без ключа — усі, що є в сцені.
scene-key-note-digits = Значущі цифри її чисел.
