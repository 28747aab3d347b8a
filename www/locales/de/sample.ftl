# Samples: their names.

## Samples

sample-icosahedron = Unterteiltes Ikosaeder
sample-bumpy-sphere = Beulige Sphäre
sample-coarse-torus = Unterteilter grober Torus
sample-clifford-torus = Clifford-Torus
sample-pipe = Rohr mit eingespannten Enden
sample-six-sided-hole = Sechsseitiges Loch
sample-scar = Narbe auf einem Stein
sample-noisy-scan = Verrauschter Scan
sample-trefoil = Kleeblattknoten
sample-vesicle = Vesikel mit weniger Volumen
sample-blob = Klumpen mit weniger Volumen
sample-spheroid = Rotationsellipsoid mit Achsen 2, 1, 1
sample-letter-c = Buchstabe C
sample-thin-torus = Dünner Torus
sample-torus-knot = Torusknoten
sample-bad-mesh = Ellipsoid, schlecht vernetzt
sample-trefoil-kept = Kleeblattknoten, Inhalt und Volumen fest
sample-trefoil-tube = Kleeblattknoten, Fläche fest
sample-linked-tubes = Zwei verschlungene Schläuche, Fläche fest
sample-bumps-kept = Beulige Sphäre, Inhalt fest
sample-ellipsoid-p = Ellipsoid, Volumen fest, p = 4
sample-cylinder-gaps = Zylinder mit vier Lücken
sample-sphere-openings = Sphäre mit acht Öffnungen
sample-two-tubes = Zwei Rohre verbunden
sample-three-tubes = Drei Rohre verbunden
sample-six-tubes = Sechs Rohre verbunden
sample-holed-scan = Scan mit gefüllten Löchern
sample-holed-sphere = Sphäre mit gefüllten Löchern
sample-dodecahedron = Dodekaeder, Ecken fest
sample-four-bumps = Vier Hügel, Flüsse im Vergleich
sample-sampled-torus = Abgetasteter Torus
sample-uneven-torus = Abgetasteter Torus, ungleichmäßig
sample-creased-face = Gesicht mit Falten
sample-eared-head = Kopf mit Ohren
sample-counterexample = Gegenbeispiel
sample-moebius = Möbiusband
sample-klein-bottle = Kleinsche Flasche
sample-saddle = Sattel, Rand frei
sample-genus-4 = Fläche mit vier Henkeln
sample-morin = Morins Fläche, angestoßen
sample-morin-fine = Morins Fläche, angestoßen, 5000 Ecken
sample-boy = Boys Fläche
sample-cyclide = Zyklide von Dupin
sample-inverted-catenoid = Invertiertes Katenoid
sample-lawson-two-handles = Auf dem Weg zu Lawsons Fläche, zwei Henkel
sample-lawson-three-handles = Auf dem Weg zu Lawsons Fläche, drei Henkel
sample-rough-mesh = Ellipsoid, verzerrte Dreiecke
sample-range-scan = Verrauschter Scan, 38 000 Ecken

## Shelves of samples

group-closed = Geschlossene Flächen
group-tubes = Rohre und Knoten
group-boundary = Mit Rand
group-repair = Reparatur
group-flips = Kantenflips
