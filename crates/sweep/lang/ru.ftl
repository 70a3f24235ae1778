# Перебор: что измеряется и почему он не начинается.
sweep-vary = `{ $vary }`: { $problem }
sweep-nothing-varied = ничего не меняется: назовите параметр, например "link.crank.mass=1 kg..5 kg:9"
sweep-twice = `{ $first }` и `{ $second }` — одно значение сцены: меняйте его один раз
sweep-many-points = в переборе { $points } точек, вычисляется не более { $most }: уменьшите число значений каждого параметра
sweep-uncounted-points = точек в переборе не сосчитать, вычисляется не более { $most }: уменьшите число значений каждого параметра
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
sweep-text = `{ $key }` — текст, а не число
sweep-takes-no-number = `{ $key }` не принимает числа
sweep-different-ends = ОТ и ДО измеряют разные величины
sweep-measure-health = наименьший определитель всех групп в положениях и где он
sweep-measure-transmission = наименьший угол передачи всех групп и где он
sweep-measure-balancing = уравновешивающая нагрузка: наибольший модуль и где он, среднее, средний модуль
sweep-measure-balancing-rms = среднеквадратичная уравновешивающая нагрузка
sweep-measure-reactions = наибольшая сила в каждой паре, наибольший момент каждой поступательной пары
sweep-measure-reaction-rms = среднеквадратичные значения этих сил и моментов
sweep-measure-extremes = крайние значения для точек, поступательных пар и углов звеньев в положениях
sweep-measure-stroke = размах перемещения каждой поступательной пары и угла каждого звена
sweep-measure-time-ratio = отношение времени более долгого хода ко времени более короткого для поступательных пар и качающихся звеньев
sweep-measure-regime = установившийся режим и привод
sweep-measure-end = последнее состояние неустановившегося движения
sweep-several-quantities = это может быть несколько величин: пишите ОТ и ДО с единицей
sweep-at-position = положение { $position }: { $problem }
sweep-in-line = { $problem } (строка { $line })
sweep-not-finite = число, найденное для `{ $column }`, бесконечно
sweep-misfit = пассивные звенья расходятся за цикл на { $misfit }
