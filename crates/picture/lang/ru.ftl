# What is written in pictures.
friction-circle = { $reaction }: круг трения { $radius }
friction-cone = { $reaction }: угол трения { $angle }
friction-cone-of-ends = { $reaction }: угол трения { $angle }, прижаты оба края
places-motor = двигатель
places-motor-as = двигатель, размеры и масса { $other }
places-gear = редуктор
places-crank = кривошип
places-title = { $shaft }
places-with-mass = { $shaft }: всего { $sum }
regime-unevenness = неравномерность
regime-least-speed = наименьшая скорость
regime-greatest-speed = наибольшая скорость
regime-input-speed = скорость входного звена
regime-course = режим
regime-first-turn = первый оборот
regime-moments = моменты на входном звене
regime-forces = силы на входном звене
regime-motor = двигатель
regime-driving-loads = движущие нагрузки
regime-resistance = сопротивление
regime-mean = среднее
regime-whole = вся
regime-delta = δ = { $delta }
regime-working-section = рабочий участок
regime-motor-speed = скорость двигателя, рад/с
regime-characteristic = механическая характеристика двигателя, Н·м
regime-links-inertia = приведённый момент инерции звеньев
regime-links-mass = приведённая масса звеньев
regime-work = работа
regime-energy-mass = диаграмма энергомасс, работа в джоулях
regime-shares = приведённый момент инерции, { $unit }: { $names }
regime-drive = привод
regime-start = начало
regime-end = конец
regime-ends = скорость входного звена в концах циклов
regime-cycle = цикл
regime-ratio = отношение
regime-flywheel = маховик
regime-parts = попытки, в долях найденных значений
regime-trial = попытка
regime-driving-work = работа движущих сил
regime-resisting-work = работа сил сопротивления
regime-friction-work = работа трения
regime-kinetic-energy = кинетическая энергия
regime-energies = энергии, Дж
motion-loads = моменты нагрузок, приведённые к входному звену
motion-forces = силы нагрузок, приведённые к входному звену
motion-over-time = время
motion-coordinate = координата
motion-time = время, с
regime-against = { $load }, против движения
regime-excess-area = A* = { $work }
instant-at = момент { $instant } ({ $time }; { $at })
position-at = положение { $position } ({ $at })
no-motion-found = Движение, которого требует сцена, не найдено:
arrow-velocity = скорость
arrow-acceleration = ускорение
arrow-first = ПФ1: скорость 1
arrow-second = ПФ2: скорость 1
index-of-balancing = ур
index-of-drive = дв
index-of-friction = тр
index-of-flywheel = мах
acting-flywheel = силы инерции маховика и ротора
acting-friction = трение в паре { $of }
acting-friction-of-slide = трение в паре { $of }, часть реакции
forces-analyzer = метод силового анализа: { $method }
forces-calculating = метод расчёта сил: { $method }; разность вычисляется
forces-two-analyzers = 1 { $one } (линия)  2 { $other } (звёзды)   наибольшая разность { $difference }
forces-hodograph = годограф: { $reaction }
forces-path = путь конца за цикл
forces-numbers = положения по их номерам
curve-zero = нуль
curve-extreme = экстремум
curve-inflection = перегиб
curve-compared = { $quantity }   1 { $one } (линия)  2 { $other } (звёзды)
curve-before = { $quantity }   1 теперь (линия)  2 до изменений (точки)
drive-title = привод
places-heading = привод с маховиком в двух местах
regime-reduced = приведено к { $point }: F { $force }, m { $mass }
following-path = траектория { $point }
following-transmission = угол передачи
motion-none = в сцене нет [motion], поэтому только J и Q; добавьте его, со speed = "60 rpm"
plans-no-construction = здесь не подходит ни один метод с построением
lever-of-drive = уравновешивающая: привод и силы инерции маховика и ротора
plans-too-small = слишком малы для этого масштаба: { $names }
plans-no-force = Здесь на эти звенья не действует ни одна сила: их нагрузки — моменты, которые уравновешиваются, или их нет; поэтому реакции нулевые, и плана сил нет.
plans-step = { $construction }, шаг { $step }
plans-more = и ещё { $count }, в списке плана
say-lost = механизм не собирается, { $place }; { $group }
say-lost-beyond = механизм не собирается, { $place }; { $group }; собирается от { $from } до { $to }
say-misses = механизм не собирается: не хватает { $gap }, { $place }; { $group }
say-no-assembly = механизм не собирается: { $reason }
say-misses-beyond = механизм не собирается: не хватает { $gap }, { $place }; { $group }; собирается от { $from } до { $to }
reduction-mechanism = механизм
reduction-model = диск: M = { $moment }, J = { $inertia }
reduction-with-flywheel = { $told } (с маховиком и ротором)

# What there is no picture of, and what to add to the scene.
add-motion = У сцены нет ни движения, ни масс для приведения. Добавьте в сцену, например:

    {"    [motion]"}
    {"    speed = \"60 rpm\""}

    или kind = "transient" (из начального состояния), или kind = "steady" (периодический режим).
add-drive = У сцены нет установившегося режима привода. Добавьте в сцену, например:

    {"    [motion]"}
    {"    kind = \"steady\""}
    {"    mean_speed = \"60 rpm\""}
    {"    unevenness = 0.05"}

    {"    [drive]"}
    {"    motor = \"auto\""}
    {"    ratio = \"solve\""}
    {"    flywheel = \"solve\""}
drive-over-time = Эта сцена движется по законам во времени, каких бы нагрузок это ни требовало: вид 5 показывает приводы, вид 3 — их нагрузки. Двигатель, режим и маховик требуют одного входа без закона.
add-loads = У сцены нет нагрузок, поэтому нет сил. Добавьте в сцену, например:

    {"    [[force]]"}
    {"    link = \""}{ $link }{"\""}
    {"    at = \""}{ $point }{"\""}
    {"    angle = \"180 deg\""}
    {"    value = \"1500 N\""}

    или gravity = "9.81 m/s^2" и массы.
drive-no-motor = у этого режима нет двигателя из каталога
forces-not-determined = в этом положении силы не определены
no-forces-found = Сил нет, так как движение, которого требует сцена, не найдено:
nothing-here = для этого вида у сцены ничего нет
events-no-dead-angle = Мёртвых углов нет: какой-то момент на входе движет механизм везде.
events-of-turn = Варианты сборки даны за полный оборот; положения сцены — его часть.
events-title = События цикла: варианты сборки, трение, стороны направляющих
assembly-input-link = Входное звено { $formula }
assembly-reaction = реакция { $of }
assembly-inner-reaction = реакция внутри группы
assembly-inner-moment = момент реакции внутри группы
assembly-group = группа { $formula }
curve-angle = угол
curve-displacement = перемещение
