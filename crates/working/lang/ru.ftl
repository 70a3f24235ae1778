# Расчёт положения: заголовки и замечания.
working-position = положение { $position }
working-sample = момент времени { $sample }
working-at-position = положения { $position }
working-at-sample = момента { $sample }, время { $time } с
working-title = { $title }: расчёт { $of }
working-structure = Строение: { $formula }
working-over-time = расчёт положения записывается для одного входа, координата которого является координатой механизма, а этот движется по законам во времени: задайте координату положения как `from`, а её скорость как `[motion] speed`
working-no-position = положения { $position } нет: сцена имеет положения от 0 до { $last }
working-load = { $place }: { $error }

# Условные обозначения.
working-conventions = Условные обозначения и допущения
working-axes = Оси: x вправо, y вверх, неподвижны относительно стойки. Углы в радианах от оси x, положительны против часовой стрелки; углы звеньев лежат между −π и π, в таблицах анализа они могут отличаться на целые обороты.
working-units = Единицы: м, кг, с, рад, Н, Н·м.
working-pf = ПФ0 — положение точки (x, y) или угол φ оси x звена; ПФ1 и ПФ2 — их первая и вторая производные по обобщённой координате q, обозначенные штрихами ′ и ″. Это не скорости: v = ПФ1·ω, a = ПФ2·ω² + ПФ1·ε, где ω = dq/dt, ε = dω/dt.
working-symbols = { $x }, { $y } — координаты точки A. { $phi } — угол звена r. { $u }, { $v } — проекции вектора от A до B в системе координат их звена. { $l } — длина. { $beta } — угол A-B от оси x звена. α, { $tx }, { $ty } — угол и единичный вектор направляющей; её нормаль (−{ $ty }, { $tx }). ψ — угол подвижного звена от направляющей.
working-symbols-of-groups = Величины одной группы имеют её номер: { $d } — определитель группы 2.
working-order = Положения находят от входного звена к последней группе, силы — от последней группы к входному звену.
working-digits = Число значащих цифр в результатах — { $digits }. Промежуточные значения хранятся со всеми цифрами; каждая строка показывает столько цифр, сколько нужно её результату, и может быть пересчитана по показанным цифрам. Результат вида { $zero } есть нуль в пределах округления.
working-atan2 = atan2({ $arguments }) — угол вектора (x, y) в его четверти.
working-assumptions = Допущения: движение плоское, звенья абсолютно жёсткие, пары без зазоров.
working-symbols-of-reactions = { $rx }, { $ry } — сила, с которой пара B действует на звено r; на другое звено действует противоположная. { $mr } — момент поступательной пары на это звено относительно названной точки; её сила приложена в этой точке перпендикулярно направляющей.
working-symbols-of-loads = { $x }, { $y } — сумма известных сил на звено r. { $m } — их момент относительно A, положительный против часовой стрелки.
working-inertia = Силы инерции: −m·a в центре масс и −I·ε; вместе с ними каждое звено находится в равновесии.
working-assumptions-of-forces = Допущения: пары без трения; силы тяжести и инерции приложены в центрах масс.
working-assumptions-with-friction = Допущения: сухое трение в тех парах, для которых оно задано, остальные без трения; силы тяжести и инерции приложены в центрах масс.
working-shares = В шарнире B более чем двух звеньев { $share } — доля только звеньев s и t; реакция B на r есть сумма долей.

# Слова в индексах, как можно короче.
working-balancing = ур
working-by-power = мощн
working-by-drive = прив
working-of-drive = дв
working-of-inertia = ин
working-of-resistance = сопр
working-of-least = min
working-of-greatest = max
working-of-mean = ср
working-of-excess = изб
working-of-flywheel = мах
working-travel = ход
working-left = лев
working-right = пр

# Входное звено.
working-input = Входное звено «{ $link }»
working-input-angle = q — угол звена «{ $link }»: φ′ = 1, φ″ = 0
working-input-displacement = q — перемещение вдоль направляющей: ПФ1 — её направление, ПФ2 = 0
working-coordinate-of-sample = координата в этот момент времени
working-first-coordinate = координата положения 0
working-whole-travel = путь за все шаги, со знаком
working-number-of-position = номер положения
working-number-of-steps = число шагов

# Группы.
working-class = класс { $class }
working-class-and-type = класс { $class }, тип { $number }
working-group = Группа { $group }, { $kind } ({ $class }), звенья { $links }: положения, ПФ1, ПФ2
working-displacement = перемещение в поступательной паре { $slide }
working-linear-system = Эта группа решена через её линейную систему из { $equations } уравнений: J u′ = b и J u″ = b, по два уравнения на каждую пару. Сначала приведено решение; ниже обе части каждого уравнения согласуются с ним.
working-pair-agrees = пара { $pair }: оба звена дают одно и то же
working-solution = решение
working-place-in-solution = место по решению
working-linear-reactions = Реакции являются решением уравнений равновесия звеньев (J транспонирована). Сначала приведены они; ниже для каждого звена их сумма противоположна сумме нагрузок.

# Нагрузки.
working-loads = Нагрузки на звенья
working-inertia-loads = Силы инерции
working-load-of = { $load }:
working-speed = скорость входного звена, dq/dt
working-acceleration = его ускорение, dω/dt
working-mass = масса
working-own-inertia = относительно центра масс
working-inertia-here = его момент инерции здесь, по формуле { $formula }
working-inertia-slope-here = производная его момента инерции по q
working-gravity = ускорение свободного падения
working-direction = направление
working-direction-in-link = направление в системе координат звена
working-none-here = в этом положении нет
working-size-here = величина в этом положении
working-on-link-here = на звено «{ $link }», в этом положении
working-spring-of-no-length = пружина нулевой длины не имеет направления: силы нет
working-stiffness = жёсткость
working-free-length = длина без нагрузки
working-damping = коэффициент сопротивления
working-where-the-force-acts = где приложена сила
working-radius = радиус
working-friction = коэффициент трения

# Уравнение движения.
working-reduction = Приведение к входному звену
working-reduced-inertia = J — удвоенная кинетическая энергия звеньев при ω = 1; J′ — её производная по q
working-reduced-moment = Q — мощность всех нагрузок, кроме движущей, при ω = 1, звено за звеном
working-equation = Уравнение движения
working-driving-moment = момент привода при этой скорости, на входном звене
working-inertia-of-drive = момент инерции маховика и ротора, приведённый к входному звену
working-check-by-drive = Проверка по приводу
working-what-the-drive-gives = Привод даёт уравновешивающую нагрузку и разгоняет маховик и ротор:
working-must-be = Должно равняться найденному выше { $quantity }.

# Реакции.
working-no-balancing = В этом положении уравновешивающая нагрузка не совершает работы: она не определена.
working-no-reactions = Реакции этой группы не определены: особое положение.
working-reactions = Реакции группы { $group }, { $kind }
working-balancing-load = Уравновешивающая нагрузка из баланса мощностей
working-unit-power = p — мощность единичной уравновешивающей нагрузки при dq = 1; её величина делает сумму мощностей нулевой
working-balancing-direction = направление уравновешивающей силы
working-check-by-power = Проверка по виртуальной мощности
working-whole-power = P — мощность всех нагрузок и сил инерции при dq = 1, звено за звеном; реакции работы не совершают
working-driven = Вход: пара { $pair }
working-driven-angle = q — угол звена «{ $link }» минус угол звена «{ $on }»
working-driven-displacement = q — перемещение звена «{ $link }» вдоль направляющей на звене «{ $on }»
working-follows-coordinate = пара { $pair } ведущая: ее движение — q, производные 1 и 0
working-input-forces = Входное звено «{ $link }»: реакция и уравновешивающая нагрузка
working-moments-about = моменты относительно { $point }:

# The working of a force analyzer.
working-of-analyzer = расчёт по силовому методу
working-by-method = Силы, найденные { $method }
working-no-method = В этом положении метод решения не имеет.
working-method-and-groups = Проверка: силы, найденные { $method }, и силы по группам
working-differences = То, что даёт метод, минус найденное по группам: нуль, кроме округления.
# Уравнение движения в форме кинетической энергии.
working-energy-way = Ход входного звена
working-energy-turns = в оборотах:
working-energy-works = Работы привода и нагрузок
working-energy-work-is = Работа нагрузки — интеграл её приведённого момента по координате: площадь под графиком момента. Нагрузка, которая сопротивляется, совершает отрицательную работу.
working-energy-work-of = Работа, { $load }:
working-energy-by-quadrature = квадратурой по движению
working-energy-moment-at = при { $at }
working-energy-sums = Суммы работ того, что движет, и того, что сопротивляется; привод и каждая нагрузка входят в одну из них своей работой за всё движение, а в результатах нагрузка движущая везде, где движет:
working-energy-excess = Избыточная работа
working-energy-change = Она равна изменению кинетической энергии:
working-energy-at-start = кинетическая энергия в начале
working-energy-of-links = Её части в конце по звеньям, m·v^2/2 + I·ω^2/2; остальное принадлежит маховику и ротору:
working-energy-of-link = в конце
working-energy-rest = В конце машина в покое: работы забирают всю кинетическую энергию.
working-energy-speed = Скорость в конце
working-energy-inertia = приведённый момент инерции в конце, с маховиком и ротором
working-energy-balance = Постоянный момент привода
working-energy-equal-works = За цикл работы привода и нагрузок равны и противоположны:
working-energy-extremes = Наименьшая и наибольшая скорость
working-energy-where = Они наступают там, где моменты привода и нагрузок равны:
working-energy-where-it-varies = Они наступают там, где кинетическая энергия изменяется так, как при постоянной скорости: при переменном приведённом моменте инерции это не там, где моменты привода и нагрузок равны.
working-energy-between = Между обоими положениями моменты совершают эту работу:
working-energy-flywheel = Маховик
working-energy-neglects = Он приведён к входному звену и содержит ротор двигателя, если тот есть; инерцией звеньев рядом с ним пренебрегают. Точный маховик, на его собственном валу, дан в результатах.
working-energy-artobolevsky = Коэффициент динамической неравномерности

## dry friction
working-friction-in-pairs = Трение в кинематических парах
working-friction-text = Трение зависит от модулей реакций. Сначала их находят без трения, затем с трением предыдущего шага и так далее; завершает метод Ньютона. Каждый шаг уменьшает погрешность примерно в спектральный радиус раз. Найденное трение далее есть нагрузка, как другие: реакции ниже даны без сил и моментов трения в их парах.
working-friction-block = { $what }: спектральный радиус { $radius }, меньше 1: решение единственно
working-friction-block-not-proved = { $what }: спектральный радиус { $radius }, не меньше 1: итерация может не сходиться, поэтому все решения находят алгебраически
working-friction-step = шаг { $step }: { $moduli }
working-friction-newton = решение: { $moduli }
working-friction-modulus = { $name } = { $value }
working-friction-pin = |R| в паре { $pair } на звено «{ $link }»
working-friction-normal = |N| в паре { $pair }
working-friction-end = |N| на конце { $end } пары { $pair }
working-friction-of = трение в паре { $pair }, найденное выше
working-friction-along = составляющая направления направляющей
working-to-point = (E, уравнения 4–6) То же, приведённое к точке { $point } входного звена, скорость которой r ω: одна сила вдоль скорости, F = Q/r, и масса в этой точке, m = J/r².
working-energy-uniform = Равноускоренное движение (D, уравнения 3.12, 3.13)
working-energy-speed-at-start = скорость в начале
working-energy-speed-at-end = скорость в конце
working-energy-by-time = (3.12) ω = ε t + { $speed }, откуда время:
working-energy-way-by-time = (3.13) Путь за это время, от начала:
working-energy-balance-resists = Постоянный момент сопротивления
working-friction-reaction = реакция в паре { $pair }, найденная выше
working-friction-pressing = нормальная сила в паре { $pair }, найденная выше
working-friction-pressing-ends = |N₁| + |N₂| на обоих концах пары { $pair }, найдено выше
working-brake-lever = отношение плеч рычага
working-brake-force = сила на рычаге
