# Зображення рисунків.
picture-size = зображення { $width } × { $height } пікселів намалювати неможливо: png має щонайбільше { $most } млн, наприклад { $side } × { $side } мм; svg може бути більшим
picture-not-painted = рисунок неможливо намалювати: { $problem }
picture-not-written = зображення неможливо записати: { $problem }
