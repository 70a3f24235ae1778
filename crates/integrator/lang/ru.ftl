integrator-sort = интегратор
integrator-state = t = { $time } с, q = { $coordinate }, w = { $speed }
integrator-out-of-range = (вне пределов чисел)
integrator-inertia-constant = J постоянно
integrator-moment-constant = M постоянно
integrator-by-name = выбран по имени
integrator-choice = случай { $case } по D ({ $equation }): { $reason }
integrator-tried-before = ранее испытан `{ $method }`: { $why }
integrator-stiff = уравнение жёсткое: явный метод вынужден был держать h·λ на уровне { $product }
integrator-inertia-not-positive = приведённый момент инерции равен { $inertia }, а должен быть положительным (задайте массу какому-нибудь подвижному звену)
integrator-acceleration-not-finite = ускорение не конечно: приведённый момент инерции { $inertia }, приведённый момент { $moment }; где подвижные звенья не имеют инерции, как в мёртвом положении, задайте её входному звену
integrator-coordinate-out-of-range = координата { integrator-out-of-range }: движение ускоряется неограниченно
integrator-bad-request = недопустимый запрос: { $fault }
integrator-unsupported = интегратор `{ $method }` не подходит для этого уравнения: { $reason }
integrator-no-method = ни один из скомпонованных интеграторов не подходит для этого уравнения ({ $equation })
integrator-step-too-small = движение не удаётся проследить дальше чем { $state }: допуск требует шагов меньше { $step } с; увеличьте его или найдите нагрузку или инерцию, которая там неограниченно растёт
integrator-too-many-steps = движение дошло до { $state } за { $steps ->
        [one] { $steps } шаг
        [few] { $steps } шага
       *[many] { $steps } шагов
    }, больше не разрешено; последний шаг { $step } с; { $advice }
integrator-implicit = неявный метод
integrator-advice-stiff = уравнение, вероятно, жёсткое (h·λ = { $product }: шаг ограничивает устойчивость, а не точность): возьмите { $method }
integrator-advice-not-stiff = оно не похоже на жёсткое (h·λ = { $product }): { integrator-advice }
integrator-advice = увеличьте допуск, разрешите больше шагов (`max_steps`) или закончите движение раньше (`until`)
integrator-unstable = постоянный шаг { $step } с неустойчив при { $state }: h·λ = { $product }, допустимо { $allowed }; возьмите шаг меньше { $below } с или { $method }, если уравнение жёсткое
integrator-end-of-range = движение доходит до границы своей области при { $state }: { $cause }; закончите его раньше (`until`) или проверьте, должен ли механизм там проходить
integrator-no-value = уравнение движения не имеет значения после { $state }: { $cause }
integrator-not-reached = { $goal } не достигается: движение дошло до { $state } и { $why }
integrator-empty-piece = уравнение движения дало пустой отрезок при { $state }: его границы должны лежать впереди движения
integrator-goal-time = время { $time } с
integrator-goal-coordinate = координата { $coordinate }
integrator-goal-turn = точка поворота
integrator-goal-rest = состояние покоя
integrator-creeps = бесконечно долго приближается к покою
integrator-many-events = имеет миллион скачков, реверсов и остановок и не заканчивается
integrator-swings = бесконечно колеблется между двумя точками поворота
integrator-endless = продолжается без конца
integrator-keeps-speed = сохраняет свою скорость
integrator-rests = остановилось там навсегда
integrator-moves-away = удаляется от неё с постоянной скоростью
integrator-time-is-over = исчерпало предел времени
integrator-nothing-brings = ничто его туда не приводит
integrator-start-not-finite = начальное состояние ({ $state }) не конечно
integrator-bad-tolerance = допуск { $tolerance }: должен быть между 0 и 1
integrator-bad-counts = `samples` и `max_steps` должны быть не меньше 1
integrator-bad-step = постоянный шаг { $step }: должен быть положительным
integrator-end-before-start = конец при { $end } с: должен быть после начала при { $start } с
integrator-end-at-start = конец при координате { $end }: движение уже в начале там
integrator-bad-end = конец при координате { $end }
integrator-end-near-start = конец при координате { $end }: ближе к началу { $start }, чем можно различить
integrator-bad-limit = предел времени { $limit } с: должен быть после начала при { $start } с
integrator-both-directions = с сухим трением движение может начаться из состояния покоя в обоих направлениях, с ускорением { $up } или { $down }: каким оно будет, не определено (Пенлеве); уменьшите коэффициенты трения
