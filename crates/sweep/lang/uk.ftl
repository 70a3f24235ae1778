# Перебір: що вимірюється і чому він не починається.
sweep-vary = `{ $vary }`: { $problem }
sweep-nothing-varied = нічого не змінюється: назвіть параметр, наприклад "link.crank.mass=1 kg..5 kg:9"
sweep-twice = `{ $first }` і `{ $second }` — те саме значення сцени: змінюйте його один раз
sweep-many-points = у переборі { $points } точок, обчислюється щонайбільше { $most }: зменште кількість значень кожного параметра
sweep-uncounted-points = у переборі забагато точок, обчислюється щонайбільше { $most }: зменште кількість значень кожного параметра
sweep-many-parameters = параметрів у вибірці { $count }, щонайбільше { $most }: залиште важливі
sweep-no-measure = показника `{ $name }` немає: назвіть якісь із { $measures } або `default` чи `all`
sweep-all-refused = жодну точку перебору не можна обчислити; перша, { $point }:
    { $problem }
sweep-no-threads = не вдалося запустити потоки ({ $threads }): { $problem }
sweep-write-grid = пишіть КЛЮЧ=ВІД..ДО:N, наприклад "link.crank.mass=1 kg..5 kg:9"
sweep-write-sample = для вибірки пишіть КЛЮЧ=ВІД..ДО, наприклад "link.crank.mass=1 kg..5 kg"
sweep-wrong-count = N — це `{ $count }`: пишіть ціле число від 1
sweep-no-number = `{ $text }`: на початку немає скінченного числа
sweep-count = `{ $key }` — кількість, вона не має одиниці
sweep-text = `{ $key }` — текст, а не число: перелічіть тексти, КЛЮЧ=A,B
sweep-takes-no-number = `{ $key }` не приймає числа
sweep-different-ends = ВІД і ДО — різні величини
sweep-measure-health = найменший визначник усіх груп у положеннях і де він
sweep-measure-transmission = найменший кут передачі всіх груп і де він
sweep-measure-balancing = зрівноважувальне навантаження: найбільший модуль і де він, середнє, середній модуль
sweep-measure-balancing-rms = середньоквадратичне зрівноважувальне навантаження
sweep-measure-reactions = найбільша сила в кожній парі, найбільший момент кожної поступальної пари
sweep-measure-reaction-rms = середньоквадратичні значення цих сил і моментів
sweep-measure-extremes = крайні значення для точок, поступальних пар і кутів ланок у положеннях
sweep-measure-stroke = хід кожної поступальної пари й розмах кожної ланки, точно й між положеннями
sweep-measure-time-ratio = час довшого ходу до часу коротшого, для поступальних пар і ланок, що хитаються, точно й між положеннями
sweep-measure-regime = усталений режим і привод
sweep-measure-end = останній стан неусталеного руху
sweep-measure-friction = сухе тертя за цикл: ККД, робота, 1 мінус найбільший спектральний радіус, довжини самогальмування та мертвих кутів
sweep-several-quantities = це може бути кілька величин: пишіть ВІД і ДО з одиницею
sweep-at-position = положення { $position }: { $problem }
sweep-in-line = { $problem } (рядок { $line })
sweep-not-finite = число, знайдене для `{ $column }`, нескінченне
sweep-misfit = пасивні ланки розходяться за цикл на { $misfit }
sweep-write-tie = запишіть як KEY=KEY, KEY=KEY*FACTOR або KEY=KEY*FACTOR+CONSTANT; другий ключ варіюється
sweep-write-best = запишіть як least:COLUMN або greatest:COLUMN
sweep-no-column = стовпця { $column } немає: один із { $columns }; --measure додає інші
sweep-tie-not-varied = він залежить від `{ $key }`, який не варіюється: назвіть той ключ у --vary
sweep-tie-other-quantity = це { $own }, а `{ $key }`, від якого він залежав би, — це { $other }: якщо так задумано, запишіть множник в одиницях SI (навіть *1)
sweep-measure-pf = найбільші модулі перших і других передавальних функцій точок, поступальних пар і ланок, і між положеннями
sweep-measure-speed = найбільші швидкості точок, поступальних пар і ланок за сталої швидкості вхідної ланки, і між положеннями
sweep-measure-acceleration = найбільші прискорення точок, поступальних пар і ланок за сталої швидкості вхідної ланки, і між положеннями
sweep-measure-shaking = головний вектор сил інерції: найбільший, середньоквадратичний; найбільший головний момент відносно початку координат, і між положеннями
sweep-measure-distance = найменша й найбільша відстань точок від місць --target, і між положеннями
sweep-write-target = пишіть POINT=X,Y, наприклад "E=100 mm,50 mm"
sweep-other-unit = число без одиниці береться в { $unit }, а в сцені { $own }; якщо мали на увазі її одиницю, напишіть "{ $instead }"
sweep-far-target = це { $away } від початку координат, а розмір механізму { $size }: число без одиниці береться в метрах; якщо мали на увазі міліметри, напишіть "{ $instead }"
sweep-no-point = такої точки в результатах немає; точки: { $points }
sweep-other-scene = сцена була інша
sweep-other-origin = `{ $key }`: було { $was }, тепер { $is }
sweep-nothing = нічого
sweep-measure-plain = найменше й найбільше значення, середнє та середньоквадратичне всього, що положення має під цим ключем у JSON
sweep-tie-to-texts = він залежить від `{ $key }`, чиї значення — тексти: зв'яжіть його з числом
sweep-at-line = { $file }, рядок { $line }: { $problem }
sweep-at-row = { $file }, рядок таблиці { $row }: { $problem }
sweep-table-column = стовпець у { $file }: { $problem }
sweep-table-cells = клітинок { $cells }, а в заголовку їх { $columns }
sweep-table-size = у таблиці точок щонайбільше { $most } клітинок
sweep-table-empty = у { $file } немає точок: її стовпці — ключі сцени, рядки — точки
sweep-uneven-lists = параметри мають різну кількість значень: { $counts }
sweep-other-shape = `{ $word }` змінює ланки, групи або стовпці: перебирайте його як окрему сцену
sweep-write-where = пишіть СТОВПЕЦЬ > ЗНАЧЕННЯ, зі знаком <, <=, > або >=, наприклад "transmission > 40 deg"
sweep-where-several = він має кілька стовпців, назвіть один: { $columns }
sweep-where-bare = пишіть число без одиниці: воно в одиниці, що стоїть у кінці `{ $column }`
sweep-status-ok = обчислено
sweep-status-no-assembly = не складається
sweep-status-no-solution = немає розв'язку
sweep-status-error = помилка
sweep-status-refused = відхилено
