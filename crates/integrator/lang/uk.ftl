integrator-sort = інтегратор
integrator-state = t = { $time } с, q = { $coordinate }, w = { $speed }
integrator-out-of-range = (поза межами чисел)
integrator-inertia-constant = J стале
integrator-moment-constant = M стале
integrator-by-name = вибрано за назвою
integrator-choice = випадок { $case } за D ({ $equation }): { $reason }
integrator-tried-before = раніше випробувано `{ $method }`: { $why }
integrator-stiff = рівняння жорстке: явний метод мусив тримати h·λ на рівні { $product }
integrator-inertia-not-positive = зведений момент інерції дорівнює { $inertia }, а має бути додатним (задайте масу якій-небудь рухомій ланці)
integrator-acceleration-not-finite = прискорення не є скінченним: зведений момент інерції { $inertia }, зведений момент { $moment }; де рухомі ланки не мають інерції, як у мертвому положенні, задайте її вхідній ланці
integrator-coordinate-out-of-range = координата { integrator-out-of-range }: рух пришвидшується необмежено
integrator-bad-request = неприпустимий запит: { $fault }
integrator-unsupported = інтегратор `{ $method }` не підходить для цього рівняння: { $reason }
integrator-no-method = жоден зі скомпонованих інтеграторів не підходить для цього рівняння ({ $equation })
integrator-step-too-small = рух не вдається простежити далі ніж { $state }: допуск потребує кроків, менших за { $step } с; збільште його або знайдіть навантаження чи інерцію, що там необмежено зростає
integrator-too-many-steps = рух дійшов до { $state } за { $steps ->
        [one] { $steps } крок
        [few] { $steps } кроки
       *[many] { $steps } кроків
    }, більше не дозволено; останній крок { $step } с; { $advice }
integrator-implicit = неявний метод
integrator-advice-stiff = рівняння, імовірно, жорстке (h·λ = { $product }: крок обмежує стійкість, а не точність): візьміть { $method }
integrator-advice-not-stiff = воно не схоже на жорстке (h·λ = { $product }): { integrator-advice }
integrator-advice = збільште допуск, дозвольте більше кроків (`max_steps`) або завершіть рух раніше (`until`)
integrator-unstable = сталий крок { $step } с нестійкий при { $state }: h·λ = { $product }, допустимо { $allowed }; візьміть крок, менший за { $below } с, або { $method }, якщо рівняння жорстке
integrator-end-of-range = рух доходить до межі своєї області при { $state }: { $cause }; завершіть його раніше (`until`) або перевірте, чи має механізм там проходити
integrator-no-value = рівняння руху не має значення після { $state }: { $cause }
integrator-not-reached = { $goal } не досягається: рух дійшов до { $state } і { $why }
integrator-empty-piece = рівняння руху дало порожній відрізок при { $state }: його межі мають лежати попереду руху
integrator-goal-time = час { $time } с
integrator-goal-coordinate = координата { $coordinate }
integrator-goal-turn = точка повороту
integrator-goal-rest = стан спокою
integrator-creeps = нескінченно довго наближається до спокою
integrator-many-events = має мільйон стрибків, реверсів і зупинок та не закінчується
integrator-swings = нескінченно коливається між двома точками повороту
integrator-endless = триває без кінця
integrator-keeps-speed = зберігає свою швидкість
integrator-rests = зупинився там назавжди
integrator-moves-away = віддаляється від неї зі сталою швидкістю
integrator-time-is-over = вичерпав межу часу
integrator-nothing-brings = ніщо його туди не приводить
integrator-start-not-finite = початковий стан ({ $state }) не є скінченним
integrator-bad-tolerance = допуск { $tolerance }: має бути між 0 і 1
integrator-bad-counts = `samples` і `max_steps` мають бути не менші за 1
integrator-bad-step = сталий крок { $step }: має бути додатним
integrator-end-before-start = кінець при { $end } с: має бути після початку при { $start } с
integrator-end-at-start = кінець при координаті { $end }: рух уже на початку там
integrator-bad-end = кінець при координаті { $end }
integrator-end-near-start = кінець при координаті { $end }: ближче до початку { $start }, ніж можна розрізнити
integrator-bad-limit = межа часу { $limit } с: має бути після початку при { $start } с
integrator-both-directions = із сухим тертям рух може початися зі стану спокою в обох напрямках, із прискоренням { $up } або { $down }: яким воно буде, не визначено (Пенлеве); зменште коефіцієнти тертя
