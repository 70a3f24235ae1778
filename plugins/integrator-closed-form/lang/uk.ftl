integrator-closed-form = J і M сталі: рівноприскорений рух, точно
    .source = D 3.12, 3.13
integrator-closed-form-suits = рівноприскорений рух має замкнений розв’язок, точний
integrator-closed-form-unfit = замкнений розв’язок потребує сталих J і M (випадок 1 за D), а тут випадок { $case }: { $equation }
integrator-quadrature = J стале, M(t) або M(w): швидкість і переміщення квадратурою за часом, час і переміщення квадратурою за швидкістю
    .source = D 3.21, випадок 2
integrator-quadrature-unfit = квадратура потребує сталого J і M сталого, M(t) або M(w) (випадки 1 і 2 за D), а тут випадок { $case }: { $equation }
integrator-quadrature-over-speed = t = J · ∫ dw / M(w) дає рух однією квадратурою за швидкістю
integrator-quadrature-over-time = імпульс моменту дає швидкість однією квадратурою за часом
integrator-quadrature-too-fine = жоден многочлен від швидкості не відтворює момент поблизу w = { $speed } (t = { $time } с) із цим допуском; метод із кроками за часом — відтворює
integrator-quadrature-settles = виходить на швидкість, до якої наближається нескінченно довго
