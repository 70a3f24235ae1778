integrator-closed-form = J и M постоянны: равноускоренное движение, точно
    .source = D 3.12, 3.13
integrator-closed-form-suits = равноускоренное движение имеет замкнутое решение, точное
integrator-closed-form-unfit = замкнутое решение требует постоянных J и M (случай 1 по D), а здесь случай { $case }: { $equation }
integrator-quadrature = J постоянно, M(t) или M(w): скорость и перемещение квадратурой по времени, время и перемещение квадратурой по скорости
    .source = D 3.21, случай 2
integrator-quadrature-unfit = квадратура требует постоянного J и M постоянного, M(t) или M(w) (случаи 1 и 2 по D), а здесь случай { $case }: { $equation }
integrator-quadrature-over-speed = t = J · ∫ dw / M(w) даёт движение одной квадратурой по скорости
integrator-quadrature-over-time = импульс момента даёт скорость одной квадратурой по времени
integrator-quadrature-too-fine = никакой многочлен от скорости не воспроизводит момент вблизи w = { $speed } (t = { $time } с) с этим допуском; метод с шагами по времени — воспроизводит
integrator-quadrature-settles = выходит на скорость, к которой приближается бесконечно долго
