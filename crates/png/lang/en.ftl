# Pictures of figures.
picture-size = a picture of { $width } x { $height } pixels can't be rendered; a png has at most { $most } million, such as { $side } x { $side } mm; an svg may be larger
picture-not-painted = the figure can't be rendered: { $problem }
picture-not-written = the picture can't be written: { $problem }
