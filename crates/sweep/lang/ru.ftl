# Перебор: что измеряется и почему он не начинается.
sweep-vary = `{ $vary }`: { $problem }
sweep-nothing-varied = ничего не меняется: назовите параметр, например "link.crank.mass=1 kg..5 kg:9"
sweep-twice = `{ $first }` и `{ $second }` — одно значение сцены: меняйте его один раз
sweep-many-points = в переборе { $points } точек, вычисляется не более { $most }: уменьшите число значений каждого параметра
sweep-uncounted-points = в переборе слишком много точек, вычисляется не более { $most }: уменьшите число значений каждого параметра
sweep-many-parameters = параметров в выборке { $count }, не более { $most }: оставьте важные
sweep-no-measure = показателя `{ $name }` нет: назовите какие-либо из { $measures } либо `default` или `all`
sweep-all-refused = ни одну точку перебора нельзя вычислить; первая, { $point }:
    { $problem }
sweep-no-threads = не удалось запустить потоки ({ $threads }): { $problem }
sweep-write-grid = пишите КЛЮЧ=ОТ..ДО:N, например "link.crank.mass=1 kg..5 kg:9"
sweep-write-sample = для выборки пишите КЛЮЧ=ОТ..ДО, например "link.crank.mass=1 kg..5 kg"
sweep-wrong-count = N — это `{ $count }`: пишите целое число от 1
sweep-no-number = `{ $text }`: в начале нет конечного числа
sweep-count = `{ $key }` — количество, у него нет единицы
sweep-text = `{ $key }` — текст, а не число: перечислите тексты, КЛЮЧ=A,B
sweep-takes-no-number = `{ $key }` не принимает числа
sweep-different-ends = ОТ и ДО — разные величины
sweep-measure-health = наименьший определитель всех групп в положениях и где он
sweep-measure-transmission = наименьший угол передачи всех групп и где он
sweep-measure-balancing = уравновешивающая нагрузка: наибольший модуль и где он, среднее, средний модуль
sweep-measure-balancing-rms = среднеквадратичная уравновешивающая нагрузка
sweep-measure-reactions = наибольшая сила в каждой паре, наибольший момент каждой поступательной пары
sweep-measure-reaction-rms = среднеквадратичные значения этих сил и моментов
sweep-measure-extremes = крайние значения для точек, поступательных пар и углов звеньев в положениях
sweep-measure-stroke = ход каждой поступательной пары и размах каждого звена, точно и между положениями
sweep-measure-time-ratio = время более длинного хода к времени более короткого, для поступательных пар и звеньев, которые качаются, точно и между положениями
sweep-measure-regime = установившийся режим и привод
sweep-measure-end = последнее состояние неустановившегося движения
sweep-measure-friction = сухое трение за цикл: КПД, работа, 1 минус наибольший спектральный радиус, длины самоторможения и мёртвых углов
sweep-several-quantities = это может быть несколько величин: пишите ОТ и ДО с единицей
sweep-at-position = положение { $position }: { $problem }
sweep-in-line = { $problem } (строка { $line })
sweep-not-finite = число, найденное для `{ $column }`, бесконечно
sweep-misfit = пассивные звенья расходятся за цикл на { $misfit }
sweep-write-tie = запишите как KEY=KEY, KEY=KEY*FACTOR или KEY=KEY*FACTOR+CONSTANT; второй ключ варьируется
sweep-write-best = запишите как least:COLUMN или greatest:COLUMN
sweep-no-column = столбца { $column } нет: один из { $columns }; --measure добавляет другие
sweep-tie-not-varied = он зависит от `{ $key }`, который не варьируется: назовите тот ключ в --vary
sweep-tie-other-quantity = это { $own }, а `{ $key }`, от которого он зависел бы, — это { $other }: если так задумано, запишите множитель в единицах SI (даже *1)
sweep-measure-pf = наибольшие модули первых и вторых передаточных функций точек, поступательных пар и звеньев, и между положениями
sweep-measure-speed = наибольшие скорости точек, поступательных пар и звеньев при постоянной скорости входного звена, и между положениями
sweep-measure-acceleration = наибольшие ускорения точек, поступательных пар и звеньев при постоянной скорости входного звена, и между положениями
sweep-measure-shaking = главный вектор сил инерции: наибольший, среднеквадратичный; наибольший главный момент относительно начала координат, и между положениями
sweep-measure-distance = наименьшее и наибольшее расстояние точек от мест --target, и между положениями
sweep-write-target = пишите POINT=X,Y, например "E=100 mm,50 mm"
sweep-other-unit = число без единицы берётся в { $unit }, а в сцене { $own }; если имелась в виду её единица, напишите "{ $instead }"
sweep-far-target = это { $away } от начала координат, а размер механизма { $size }: число без единицы берётся в метрах; если имелись в виду миллиметры, напишите "{ $instead }"
sweep-no-point = такой точки в результатах нет; точки: { $points }
sweep-other-scene = сцена была другой
sweep-other-origin = `{ $key }`: было { $was }, теперь { $is }
sweep-nothing = ничего
sweep-measure-plain = наименьшее и наибольшее значение, среднее и среднеквадратичное всего, что положение имеет под этим ключом в JSON
sweep-tie-to-texts = он зависит от `{ $key }`, чьи значения — тексты: свяжите его с числом
sweep-at-line = { $file }, строка { $line }: { $problem }
sweep-at-row = { $file }, строка таблицы { $row }: { $problem }
sweep-table-column = столбец в { $file }: { $problem }
sweep-table-cells = ячеек { $cells }, а в заголовке их { $columns }
sweep-table-size = в таблице точек не более { $most } ячеек
sweep-table-empty = в { $file } нет точек: её столбцы — ключи сцены, строки — точки
sweep-uneven-lists = у параметров разное количество значений: { $counts }
sweep-other-shape = `{ $word }` меняет звенья, группы или столбцы: перебирайте его как отдельную сцену
sweep-write-where = пишите СТОЛБЕЦ > ЗНАЧЕНИЕ, со знаком <, <=, > или >=, например "transmission > 40 deg"
sweep-where-several = у него несколько столбцов, назовите один: { $columns }
sweep-where-bare = пишите число без единицы: оно в единице, стоящей в конце `{ $column }`
sweep-status-ok = рассчитано
sweep-status-no-assembly = не собирается
sweep-status-no-solution = нет решения
sweep-status-error = ошибка
sweep-status-refused = отклонено
