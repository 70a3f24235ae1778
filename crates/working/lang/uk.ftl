# Розрахунок положення: заголовки й примітки.
working-position = положення { $position }
working-sample = момент часу { $sample }
working-at-position = положення { $position }
working-at-sample = моменту { $sample }, час { $time } с
working-title = { $title }: розрахунок { $of }
working-structure = Будова: { $formula }
working-over-time = розрахунок положення записується для одного входу, координата якого є координатою механізму, а цей рухається за законами в часі: задайте координату положення як `from`, а її швидкість як `[motion] speed`
working-no-position = положення { $position } немає: сцена має положення від 0 до { $last }
working-load = { $place }: { $error }

# Умовні позначення.
working-conventions = Умовні позначення та припущення
working-axes = Осі: x праворуч, y угору, нерухомі відносно стояка. Кути в радіанах від осі x, додатні проти годинникової стрілки; кути ланок лежать між −π та π, у таблицях аналізу вони можуть відрізнятися на цілі оберти.
working-units = Одиниці: м, кг, с, рад, Н, Н·м.
working-pf = ПФ0 — положення точки (x, y) або кут φ осі x ланки; ПФ1 і ПФ2 — їхні перша та друга похідні за узагальненою координатою q, позначені штрихами ′ і ″. Це не швидкості: v = ПФ1·ω, a = ПФ2·ω² + ПФ1·ε, де ω = dq/dt, ε = dω/dt.
working-symbols = { $x }, { $y } — координати точки A. { $phi } — кут ланки r. { $u }, { $v } — проєкції вектора від A до B у системі координат їхньої ланки. { $l } — довжина. { $beta } — кут A-B від осі x ланки. α, { $tx }, { $ty } — кут і одиничний вектор напрямної; її нормаль (−{ $ty }, { $tx }). ψ — кут рухомої ланки від напрямної.
working-symbols-of-groups = Величини однієї групи мають її номер: { $d } — визначник групи 2.
working-order = Положення знаходять від вхідної ланки до останньої групи, сили — від останньої групи до вхідної ланки.
working-digits = Кількість значущих цифр у результатах — { $digits }. Проміжні значення зберігаються з усіма цифрами; кожен рядок показує стільки цифр, скільки потребує його результат, і його можна перерахувати за показаними цифрами. Результат на зразок { $zero } є нулем у межах округлення.
working-atan2 = atan2({ $arguments }) — кут вектора (x, y) у його чверті.
working-assumptions = Припущення: рух плоский, ланки абсолютно жорсткі, пари без зазорів.
working-symbols-of-reactions = { $rx }, { $ry } — сила, з якою пара B діє на ланку r; на іншу ланку діє протилежна. { $mr } — момент поступальної пари на цю ланку відносно названої точки; її сила прикладена в цій точці перпендикулярно до напрямної.
working-symbols-of-loads = { $x }, { $y } — сума відомих сил на ланку r. { $m } — їхній момент відносно A, додатний проти годинникової стрілки.
working-inertia = Сили інерції: −m·a у центрі мас і −I·ε; разом із ними кожна ланка перебуває в рівновазі.
working-assumptions-of-forces = Припущення: пари без тертя; сили ваги та інерції прикладені в центрах мас.
working-assumptions-with-friction = Припущення: сухе тертя в тих парах, для яких його задано, решта без тертя; сили ваги та інерції прикладені в центрах мас.
working-shares = У шарнірі B більш ніж двох ланок { $share } — частка лише ланок s і t; реакція B на r є сумою часток.

# Слова в індексах, якомога коротші.
working-balancing = зр
working-by-power = пот
working-by-drive = прив
working-of-drive = дв
working-of-inertia = ін
working-of-resistance = оп
working-of-least = min
working-of-greatest = max
working-of-mean = ср
working-of-excess = надл
working-of-flywheel = мах
working-travel = хід
working-left = лів
working-right = пр

# Вхідна ланка.
working-input = Вхідна ланка «{ $link }»
working-input-angle = q — кут ланки «{ $link }»: φ′ = 1, φ″ = 0
working-input-displacement = q — переміщення вздовж напрямної: ПФ1 — її напрям, ПФ2 = 0
working-coordinate-of-sample = координата в цей момент часу
working-first-coordinate = координата положення 0
working-whole-travel = шлях за всі кроки, зі знаком
working-number-of-position = номер положення
working-number-of-steps = кількість кроків

# Групи.
working-class = клас { $class }
working-class-and-type = клас { $class }, тип { $number }
working-group = Група { $group }, { $kind } ({ $class }), ланки { $links }: положення, ПФ1, ПФ2
working-displacement = переміщення в поступальній парі { $slide }
working-linear-system = Цю групу розв'язано через її лінійну систему з { $equations } рівнянь: J u′ = b і J u″ = b, по два рівняння на кожну пару. Спершу наведено розв'язок; нижче обидві частини кожного рівняння узгоджуються з ним.
working-pair-agrees = пара { $pair }: обидві ланки дають те саме
working-solution = розв'язок
working-place-in-solution = місце за розв'язком
working-linear-reactions = Реакції є розв'язком рівнянь рівноваги ланок (J транспонована). Спершу наведено їх; нижче для кожної ланки їхня сума протилежна сумі навантажень.

# Навантаження.
working-loads = Навантаження на ланки
working-inertia-loads = Сили інерції
working-load-of = { $load }:
working-speed = швидкість вхідної ланки, dq/dt
working-acceleration = її прискорення, dω/dt
working-mass = маса
working-own-inertia = відносно центра мас
working-inertia-here = її момент інерції тут, за формулою { $formula }
working-inertia-slope-here = похідна її моменту інерції за q
working-gravity = прискорення вільного падіння
working-direction = напрям
working-direction-in-link = напрям у системі координат ланки
working-none-here = у цьому положенні немає
working-size-here = величина в цьому положенні
working-on-link-here = на ланку «{ $link }», у цьому положенні
working-spring-of-no-length = пружина нульової довжини не має напряму: сили немає
working-stiffness = жорсткість
working-free-length = довжина без навантаження
working-damping = коефіцієнт опору
working-where-the-force-acts = де прикладена сила
working-radius = радіус
working-friction = коефіцієнт тертя

# Рівняння руху.
working-reduction = Зведення до вхідної ланки
working-reduced-inertia = J — подвоєна кінетична енергія ланок за ω = 1; J′ — її похідна за q
working-reduced-moment = Q — потужність усіх навантажень, крім рушійного, за ω = 1, ланка за ланкою
working-equation = Рівняння руху
working-driving-moment = момент приводу за цієї швидкості, на вхідній ланці
working-inertia-of-drive = момент інерції маховика й ротора, зведений до вхідної ланки
working-check-by-drive = Перевірка за приводом
working-what-the-drive-gives = Привод дає зрівноважувальне навантаження і розганяє маховик та ротор:
working-must-be = Має дорівнювати знайденому вище { $quantity }.

# Реакції.
working-no-balancing = У цьому положенні зрівноважувальне навантаження не виконує роботи: його не визначено.
working-no-reactions = Реакції цієї групи не визначені: особливе положення.
working-reactions = Реакції групи { $group }, { $kind }
working-balancing-load = Зрівноважувальне навантаження з балансу потужностей
working-unit-power = p — потужність одиничного зрівноважувального навантаження за dq = 1; його величина робить суму потужностей нульовою
working-balancing-direction = напрям зрівноважувальної сили
working-check-by-power = Перевірка за віртуальною потужністю
working-whole-power = P — потужність усіх навантажень і сил інерції за dq = 1, ланка за ланкою; реакції роботи не виконують
working-driven = Вхід: пара { $pair }
working-driven-angle = q — кут ланки «{ $link }» мінус кут ланки «{ $on }»
working-driven-displacement = q — переміщення ланки «{ $link }» уздовж напрямної на ланці «{ $on }»
working-follows-coordinate = пара { $pair } ведуча: її рух — q, похідні 1 і 0
working-input-forces = Вхідна ланка «{ $link }»: реакція та зрівноважувальне навантаження
working-moments-about = моменти відносно { $point }:

# The working of a force analyzer.
working-of-analyzer = розрахунок за силовим методом
working-by-method = Сили, знайдені { $method }
working-no-method = У цьому положенні метод розв’язку не має.
working-method-and-groups = Перевірка: сили, знайдені { $method }, і сили за групами
working-differences = Те, що дає метод, мінус знайдене за групами: нуль, крім округлення.
# Рівняння руху у формі кінетичної енергії.
working-energy-way = Хід вхідної ланки
working-energy-turns = в обертах:
working-energy-works = Роботи приводу й навантажень
working-energy-work-is = Робота навантаження — інтеграл його зведеного моменту за координатою: площа під графіком моменту. Навантаження, що чинить опір, виконує від'ємну роботу.
working-energy-work-of = Робота, { $load }:
working-energy-by-quadrature = квадратурою за рухом
working-energy-moment-at = за { $at }
working-energy-sums = Суми робіт того, що рухає, і того, що чинить опір; привод і кожне навантаження входять до однієї з них своєю роботою за весь рух, а в результатах навантаження рушійне всюди, де рухає:
working-energy-excess = Надлишкова робота
working-energy-change = Вона є зміною кінетичної енергії:
working-energy-at-start = кінетична енергія на початку
working-energy-of-links = Її частини в кінці за ланками, m·v^2/2 + I·ω^2/2; решта належить маховику й ротору:
working-energy-of-link = у кінці
working-energy-rest = У кінці машина перебуває в спокої: роботи забирають усю кінетичну енергію.
working-energy-speed = Швидкість у кінці
working-energy-inertia = зведений момент інерції в кінці, з маховиком і ротором
working-energy-balance = Сталий момент приводу
working-energy-equal-works = За цикл роботи приводу й навантажень рівні та протилежні:
working-energy-extremes = Найменша та найбільша швидкість
working-energy-where = Вони настають там, де моменти приводу й навантажень рівні:
working-energy-where-it-varies = Вони настають там, де кінетична енергія змінюється так, ніби швидкість стала: за змінного зведеного моменту інерції це не там, де моменти приводу й навантажень рівні.
working-energy-between = Між обома положеннями моменти виконують цю роботу:
working-energy-flywheel = Маховик
working-energy-neglects = Він зведений до вхідної ланки й містить ротор двигуна, якщо той є; інерцією ланок поруч із ним знехтувано. Точний маховик, на його власному валу, подано в результатах.
working-energy-artobolevsky = Коефіцієнт динамічної нерівномірності

## dry friction
working-friction-in-pairs = Тертя в кінематичних парах
working-friction-text = Тертя залежить від модулів реакцій. Спочатку їх знаходять без тертя, потім з тертям попереднього кроку і так далі; завершує метод Ньютона. Кожен крок зменшує похибку приблизно у спектральний радіус разів. Знайдене тертя далі є навантаженням, як інші: реакції нижче подано без сил і моментів тертя в їхніх парах.
working-friction-block = { $what }: спектральний радіус { $radius }, менший за 1: розв'язок єдиний
working-friction-block-not-proved = { $what }: спектральний радіус { $radius }, не менший за 1: ітерація може не збігатися, тому всі розв'язки знаходять алгебрично
working-friction-step = крок { $step }: { $moduli }
working-friction-newton = розв'язок: { $moduli }
working-friction-modulus = { $name } = { $value }
working-friction-pin = |R| у парі { $pair } на ланку «{ $link }»
working-friction-normal = |N| у парі { $pair }
working-friction-end = |N| на кінці { $end } пари { $pair }
working-friction-of = тертя в парі { $pair }, знайдене вище
working-friction-along = складова напрямку напрямної
working-to-point = (E, рівняння 4–6) Те саме, зведене до точки { $point } вхідної ланки, швидкість якої r ω: одна сила вздовж швидкості, F = Q/r, і маса в цій точці, m = J/r².
working-energy-uniform = Рівноприскорений рух (D, рівняння 3.12, 3.13)
working-energy-speed-at-start = швидкість на початку
working-energy-speed-at-end = швидкість у кінці
working-energy-by-time = (3.12) ω = ε t + { $speed }, звідки час:
working-energy-way-by-time = (3.13) Шлях за цей час, від початку:
working-energy-balance-resists = Сталий момент опору
working-friction-reaction = реакція в парі { $pair }, знайдена вище
working-friction-pressing = нормальна сила в парі { $pair }, знайдена вище
working-friction-pressing-ends = |N₁| + |N₂| на обох кінцях пари { $pair }, знайдено вище
working-brake-lever = відношення плечей важеля
working-brake-force = сила на важелі
