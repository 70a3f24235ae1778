# What is written in pictures.
friction-circle = { $reaction }: круг тертя { $radius }
friction-cone = { $reaction }: кут тертя { $angle }
friction-cone-of-ends = { $reaction }: кут тертя { $angle }, притиснуті обидва краї
places-motor = двигун
places-motor-as = двигун, розміри й маса { $other }
places-gear = редуктор
places-crank = кривошип
places-title = { $shaft }
places-with-mass = { $shaft }: усього { $sum }
regime-unevenness = нерівномірність
regime-least-speed = найменша швидкість
regime-greatest-speed = найбільша швидкість
regime-input-speed = швидкість вхідної ланки
regime-course = режим
regime-first-turn = перший оберт
regime-moments = моменти на вхідній ланці
regime-forces = сили на вхідній ланці
regime-motor = двигун
regime-driving-loads = рушійні навантаження
regime-resistance = опір
regime-mean = середнє
regime-whole = уся
regime-delta = δ = { $delta }
regime-working-section = робоча ділянка
regime-motor-speed = швидкість двигуна, рад/с
regime-characteristic = механічна характеристика двигуна, Н·м
regime-links-inertia = зведений момент інерції ланок
regime-links-mass = зведена маса ланок
regime-work = робота
regime-energy-mass = діаграма енергомас, робота в джоулях
regime-shares = зведений момент інерції, { $unit }: { $names }
regime-drive = привод
regime-start = початок
regime-end = кінець
regime-ends = швидкість вхідної ланки на кінцях циклів
regime-cycle = цикл
regime-ratio = відношення
regime-flywheel = маховик
regime-parts = спроби, у частках знайдених значень
regime-trial = спроба
regime-driving-work = робота рушійних сил
regime-resisting-work = робота сил опору
regime-friction-work = робота тертя
regime-kinetic-energy = кінетична енергія
regime-energies = енергії, Дж
motion-loads = моменти навантажень, зведені до вхідної ланки
motion-forces = сили навантажень, зведені до вхідної ланки
motion-over-time = час
motion-coordinate = координата
motion-time = час, с
regime-against = { $load }, проти руху
regime-excess-area = A* = { $work }
instant-at = момент { $instant } ({ $time }; { $at })
position-at = положення { $position } ({ $at })
no-motion-found = Руху, якого вимагає сцена, не знайдено:
arrow-velocity = швидкість
arrow-acceleration = прискорення
arrow-first = ПФ1: швидкість 1
arrow-second = ПФ2: швидкість 1
index-of-balancing = зр
index-of-drive = дв
index-of-friction = тр
index-of-flywheel = мах
acting-flywheel = сили інерції маховика й ротора
acting-friction = тертя в парі { $of }
acting-friction-of-slide = тертя в парі { $of }, частина реакції
forces-analyzer = метод силового аналізу: { $method }
forces-calculating = метод розрахунку сил: { $method }; різниця обчислюється
forces-two-analyzers = 1 { $one } (лінія)  2 { $other } (зірки)   найбільша різниця { $difference }
forces-hodograph = годограф: { $reaction }
forces-path = шлях кінця за цикл
forces-numbers = положення за їхніми номерами
curve-zero = нуль
curve-extreme = екстремум
curve-inflection = перегин
curve-compared = { $quantity }   1 { $one } (лінія)  2 { $other } (зірки)
curve-before = { $quantity }   1 тепер (лінія)  2 до змін (крапки)
drive-title = привод
places-heading = привод із маховиком у двох місцях
regime-reduced = зведено до { $point }: F { $force }, m { $mass }
following-path = траєкторія { $point }
following-transmission = кут передавання
motion-none = у сцені немає [motion], тому лише J і Q; додайте його, зі speed = "60 rpm"
plans-no-construction = тут не підходить жоден метод із побудовою
lever-of-drive = зрівноважувальне: привід і сили інерції маховика й ротора
plans-too-small = замалі для цього масштабу: { $names }
plans-no-force = Тут на ці ланки не діє жодна сила: їхні навантаження — моменти, що зрівноважуються, або їх немає; тому реакції нульові, і плану сил немає.
plans-step = { $construction }, крок { $step }
plans-more = і ще { $count }, у списку плану
say-lost = механізм не складається, { $place }; { $group }
say-lost-beyond = механізм не складається, { $place }; { $group }; складається від { $from } до { $to }
say-misses = механізм не складається: бракує { $gap }, { $place }; { $group }
say-no-assembly = механізм не складається: { $reason }
say-misses-beyond = механізм не складається: бракує { $gap }, { $place }; { $group }; складається від { $from } до { $to }
reduction-mechanism = механізм
reduction-model = диск: M = { $moment }, J = { $inertia }
reduction-with-flywheel = { $told } (з маховиком і ротором)

# What there is no picture of, and what to add to the scene.
add-motion = Сцена не має ні руху, ні мас для зведення. Додайте до сцени, наприклад:

    {"    [motion]"}
    {"    speed = \"60 rpm\""}

    або kind = "transient" (з початкового стану), або kind = "steady" (періодичний режим).
add-drive = Сцена не має усталеного режиму приводу. Додайте до сцени, наприклад:

    {"    [motion]"}
    {"    kind = \"steady\""}
    {"    mean_speed = \"60 rpm\""}
    {"    unevenness = 0.05"}

    {"    [drive]"}
    {"    motor = \"auto\""}
    {"    ratio = \"solve\""}
    {"    flywheel = \"solve\""}
drive-over-time = Ця сцена рухається за законами в часі, хоч яких навантажень це потребує: вид 5 показує приводи, вид 3 — їхні навантаження. Двигун, режим і маховик потребують одного входу без закону.
add-loads = Сцена не має навантажень, тому немає сил. Додайте до сцени, наприклад:

    {"    [[force]]"}
    {"    link = \""}{ $link }{"\""}
    {"    at = \""}{ $point }{"\""}
    {"    angle = \"180 deg\""}
    {"    value = \"1500 N\""}

    або gravity = "9.81 m/s^2" і маси.
drive-no-motor = у цього режиму немає двигуна з каталогу
forces-not-determined = у цьому положенні сили не визначено
no-forces-found = Сил немає, бо руху, якого вимагає сцена, не знайдено:
nothing-here = для цього виду сцена не має нічого
events-no-dead-angle = Мертвих кутів немає: якийсь момент на вході рухає механізм усюди.
events-of-turn = Варіанти складання подано за повний оберт; положення сцени — його частина.
events-title = Події циклу: варіанти складання, тертя, боки напрямних
assembly-input-link = Вхідна ланка { $formula }
assembly-reaction = реакція { $of }
assembly-inner-reaction = реакція всередині групи
assembly-inner-moment = момент реакції всередині групи
assembly-group = група { $formula }
curve-angle = кут
curve-displacement = переміщення
