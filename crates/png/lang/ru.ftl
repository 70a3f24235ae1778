# Изображения рисунков.
picture-size = изображение { $width } × { $height } пикселей нарисовать невозможно: у png не более { $most } млн, например { $side } × { $side } мм; svg может быть больше
picture-not-painted = рисунок невозможно нарисовать: { $problem }
picture-not-written = изображение невозможно записать: { $problem }
