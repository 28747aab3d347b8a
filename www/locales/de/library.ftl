# Was zur Wahl steht: Flüsse, Beispiele, die Bilder der Arbeiten und was an ihnen gemessen wurde.

## Flüsse: ihre Namen, und die schlichte Zeile darunter

flow-circle = Willmore durch Kreiswinkel
    .plain = So rund wie möglich. Für jedes Netz.
flow-p-willmore = p-Willmore
    .plain = Flächeninhalt oder Volumen fest, jeder Exponent p.
flow-mean-curvature = Mittlere Krümmung
    .plain = Verkleinert die Fläche so schnell wie möglich.
flow-volume-preserving = Mittlere Krümmung bei festem Volumen
    .plain = Verkleinert die Fläche, das Volumen bleibt.
flow-surface-diffusion = Oberflächendiffusion
    .plain = Glättet die Fläche, das Volumen bleibt.
flow-willmore = Willmore durch angepasste Operatoren
    .plain = So wenig gebogen, wie das Feste es zulässt.
flow-mmcv = Minimale Krümmungsvariation, sechster Ordnung
    .plain = Das glatteste Stück: Krümmung ohne Wechsel.
flow-flips = Kantenflips
    .plain = Bewegt keine Ecke, tauscht nur Kanten.

## Beispiele

sample-icosahedron = Unterteiltes Ikosaeder
sample-bumpy-sphere = Beulige Sphäre
sample-clifford-torus = Clifford-Torus
sample-pipe = Rohr mit eingespannten Enden
sample-six-sided-hole = Sechsseitiges Loch
sample-scar = Narbe auf einem Stein
sample-noisy-scan = Verrauschter Scan
sample-trefoil = Kleeblattknoten
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

## Regale der Beispiele

group-closed = Geschlossene Flächen
group-tubes = Rohre und Knoten
group-boundary = Mit Rand
group-repair = Reparatur
group-flips = Kantenflips

## Arbeiten

paper-circle = { paper-circle.authors }: diskreter Willmore-Fluss
    .authors = Bobenko und Schröder
paper-p-willmore = { paper-p-willmore.authors }: p-Willmore-Fluss
    .authors = Gruber und Aulisa
paper-flips = { paper-flips.authors }: Kantenflips
    .authors = Brink und Alboul
paper-curvature = { paper-curvature.authors }: Variation der mittleren Krümmung
    .authors = Xu und Zhang
paper-volume-preserving = { paper-volume-preserving.authors }: mittlere Krümmung bei festem Volumen
    .authors = Huisken
paper-eversion = { paper-eversion.authors }: Umstülpung der Sphäre
    .authors = Francis, Sullivan, Kusner, Brakke, Hartman und Chappell
paper-lawson = { paper-lawson.authors }: Minimalflächen der 3-Sphäre
    .authors = Lawson
paper-knots = { paper-knots.authors }: reguläre Homotopie von Flächen
    .authors = Pinkall

## Figures: their number; the paper’s report and what to expect here

figure-circle-6 = Abb. { $number }
    .title = Unterteiltes Ikosaeder zur Sphäre
    .reports = Nach 24 Schritten ist die Energie 1e-7; eine vollkommene Sphäre hätte null.
    .expected = W beginnt bei 60π und ist nach 24 Schritten mit dt = 0.0345 höchstens 1e-7; eine runde Sphäre
figure-circle-6-adaptive = Abb. { $number }
    .title = Unterteiltes Ikosaeder, angepasste Schritte
    .reports = Die Sphäre ist nach wenigen Minimierungsschritten erreicht.
    .expected = W ≤ 1e-7 nach höchstens 12 Schritten, dann konvergiert
figure-circle-7-fixed = Abb. { $number }, links
    .title = Rand fest
    .reports = Ein Katzenkopf mit festem Rand entspannt sich zwischen seinen Randkurven.
    .expected = Eine andere Form, ein Sattel: W fällt um mindestens neun Zehntel, die Fläche bleibt gekrümmt
figure-circle-7-free = Abb. { $number }, rechts
    .title = Rand frei
    .reports = Ein Katzenkopf mit freiem Rand wird zu einem ebenen Polygon mit konvexem Rand.
    .expected = Eine andere Form, ein Sattel: W < 1e-6, also eben mit konvexem Rand
figure-circle-8 = Abb. { $number }
    .title = Grober Torus wird geometrisch
    .reports = Fast sofort fließen die Ecken auf einen geometrischen Torus.
    .expected = τ = 0.01: W nach 100 Schritten auf 5 % genau 57, ein Torus auf 2.5 %
figure-circle-8-long = Abb. { $number }, lang
    .title = Grober Torus wird dicker
    .reports = Im weiteren Verlauf richten sich Kanten nach den Krümmungsrichtungen aus, und der Torus wird dicker.
    .expected = τ = 0.003, 1000 Schritte: R/r von 2.13 auf 2.04 (±0.02), ein Torus auf 1.5 %
figure-circle-9 = Abb. { $number }
    .title = Rohr zwischen zwei Kreisen
    .reports = Ein Rohr mit kreisförmigen Randkurven entwickelt sich wie der Torus, zu einem dicken Rohr.
    .expected = W von 398.65 auf unter 80 in 50 Schritten
figure-circle-10 = Abb. { $number }
    .title = Sechsseitiges Loch gefüllt
    .reports = Ein sechsseitiges Loch wird glatt gefüllt, obwohl viele Kanten mit β = 0 beginnen.
    .expected = Nicht eingefroren: Nach 100 Schritten ist W um mindestens 60 kleiner
figure-circle-11 = Abb. { $number }
    .title = Narbe geheilt
    .reports = Ein markierter Bereich des Egea-Modells wird wiederhergestellt, seine Umgebung festgehalten.
    .expected = Eine andere Form, ein Stein mit Narbe: W in 20 Schritten auf 2 % genau 6.408, wo der unbeschädigte Stein zur Ruhe kommt
figure-circle-12-10 = Abb. { $number }, 10 Schritte
    .title = Scan in 10 Schritten geglättet
    .reports = Ein Scan mit 37 000 Ecken und 88 Randkurven verliert sein Rauschen; gezeigt nach 10 Schritten.
    .expected = Ein künstlicher Scan mit 88 Randkurven und 38 000 Ecken: Abstand zur sauberen Fläche unter dem 0.7-Fachen des Rauschens
figure-circle-12-100 = Abb. { $number }, 100 Schritte
    .title = Scan in 100 Schritten geglättet
    .reports = Ein Scan mit 37 000 Ecken und 88 Randkurven verliert sein Rauschen; gezeigt nach 100 Schritten.
    .expected = Ein künstlicher Scan mit 88 Randkurven und 38 000 Ecken, dessen Merkmale zu schwinden beginnen: Abstand zur sauberen Fläche unter dem 1.5-Fachen des Rauschens
figure-p-willmore-1 = Abb. { $number }
    .title = Flächeninhalt fest, p = 2
    .reports = Eine Kuh aus 23 400 Dreiecken rundet sich, ihr Flächeninhalt fast unverändert.
    .expected = Eine andere Form, eine beulige Sphäre: ∫H² auf 0.6 % genau 4π, eine Sphäre auf 1e-3, Inhalt auf 1e-8
figure-p-willmore-2-p0 = Abb. { $number }, p = 0
    .title = Buchstabe C, p = 0
    .reports = Mit p = 0, dem Fluss nach der mittleren Krümmung, schrumpft der Buchstabe C.
    .expected = Flächeninhalt unter einem Fünftel nach höchstens 100 Schritten
figure-p-willmore-2-p2 = Abb. { $number }, p = 2
    .title = Buchstabe C, p = 2
    .reports = Mit p = 2 wird der Buchstabe C zur runden Sphäre.
    .expected = ∫H² auf 1 % genau das einer Sphäre nach höchstens 160 Schritten
figure-p-willmore-2-p4 = Abb. { $number }, p = 4
    .title = Buchstabe C, p = 4
    .reports = Mit p = 4 wächst der Buchstabe C ohne Ende.
    .expected = Flächeninhalt mehr als das 1.8-Fache nach höchstens 160 Schritten
figure-p-willmore-3-linear = Abb. { $number }, linear
    .title = Regularisierung, linear
    .reports = Lineare Regularisierung verbessert das Netz einer Kuh, gröber als die nichtlineare, mit leichten Änderungen ihrer Form.
    .expected = Eine andere Form, ein Ellipsoid mit umgeklappten Dreiecken: keines mehr, Verzerrung unter einem Drittel, um weniger als 1 % seiner Größe bewegt
figure-p-willmore-3-nonlinear = Abb. { $number }, nichtlinear
    .title = Regularisierung, nichtlinear
    .reports = Nichtlineare Regularisierung verbessert das Netz einer Kuh, mit leichten Änderungen ihrer Form.
    .expected = Eine andere Form, ein Ellipsoid mit umgeklappten Dreiecken: keines mehr, Verzerrung unter einem Drittel, um weniger als 1 % seiner Größe bewegt
figure-p-willmore-4 = Abb. { $number }
    .title = Torus zum Clifford-Torus
    .reports = Ein verformter Torus fließt zum Clifford-Torus, dem globalen Minimum.
    .expected = Ein dünner Torus: ∫H² auf 1.6 % genau 2π², reduziertes Volumen auf 1.2 % genau 0.7116
figure-p-willmore-5 = Abb. { $number }
    .title = Torusknoten, Inhalt und Volumen fest
    .reports = Ein (3,4)-Torusknoten entspannt sich bei festem Inhalt und Volumen und bleibt beinahe isometrisch.
    .expected = ∫H² fällt, Inhalt und Volumen auf 1e-8, kleinster Winkel über der Hälfte des ersten
figure-p-willmore-6 = Abb. { $number }
    .title = Bikonkave Scheibe aus einem Vesikel
    .reports = Ein Hase mit festem Inhalt und Volumen wird zur bikonkaven Scheibe wie ein rotes Blutkörperchen.
    .expected = Eine andere Form, ein Rotationsellipsoid, auf v = 0.6 geführt: ∫H² auf 1.2 % genau 1.95568·4π, das rotationssymmetrische Minimum
figure-p-willmore-6-blob = Abb. { $number }
    .title = Bikonkave Scheibe aus einem Klumpen
    .reports = Ein Hase mit festem Inhalt und Volumen wird zur bikonkaven Scheibe wie ein rotes Blutkörperchen.
    .expected = Eine andere Form, ein Klumpen ohne Symmetrie, auf v = 0.6 geführt: ∫H² auf 1.2 % genau 1.95568·4π, das rotationssymmetrische Minimum
figure-p-willmore-7 = Abb. { $number }
    .title = Ein Durchgang linearer Regularisierung
    .reports = Ein linearer Durchgang verbessert eine Statue aus 483 000 Dreiecken.
    .expected = Eine andere Form, ein Ellipsoid mit verzerrten Dreiecken: keines umgeklappt, Verzerrung unter einem Drittel, um weniger als 1 % bewegt
figure-p-willmore-8 = Abb. { $number }
    .title = Geschlecht 4, frei
    .reports = Eine Statue vom Geschlecht 4 fließt zu einer runden Fläche mit vier Henkeln.
    .expected = Eine andere Fläche vom Geschlecht 4: ∫H² von oben zwischen 2π² und 8π
figure-p-willmore-9 = Abb. { $number }, oben
    .title = Kleeblattknoten, regularisiert
    .reports = Regularisiert behält ein Kleeblattknoten bis zum Minimum fast vollkommene Dreiecke.
    .expected = ∫H² fällt auf ein Plateau, Inhalt und Volumen auf 1e-8, kleinster Winkel nicht unter dem ersten (ein endgültiges Minimum ist nicht bekannt)
figure-p-willmore-9-off = Abb. { $number }, unten
    .title = Kleeblattknoten, nicht regularisiert
    .reports = Ohne Regularisierung entartet das Netz, und der Fluss bleibt stecken.
    .expected = Inhalt und Volumen auf 1e-8, kleinster Winkel unter der Hälfte des ersten
figure-p-willmore-10-p0 = Abb. { $number }, p = 0
    .title = Energie bei Verfeinerung, p = 0
    .reports = Die Energie fällt in jedem Fall und scheint bei Verfeinerung zu konvergieren.
    .expected = Eine andere Form, ein Ellipsoid auf drei Netzen: Zur selben Zeit rücken die Energien um das 3- bis 5-Fache zusammen
figure-p-willmore-10-p2 = Abb. { $number }, p = 2
    .title = Energie bei Verfeinerung, p = 2
    .reports = Die Energie fällt in jedem Fall und scheint bei Verfeinerung zu konvergieren.
    .expected = Eine andere Form, ein Ellipsoid auf drei Netzen: Zur selben Zeit rücken die Energien um das 3- bis 5-Fache zusammen
figure-p-willmore-10-p4 = Abb. { $number }, p = 4
    .title = Energie bei Verfeinerung, p = 4
    .reports = Die Energie fällt in jedem Fall und scheint bei Verfeinerung zu konvergieren.
    .expected = Eine andere Form, ein Ellipsoid auf drei Netzen: Zur selben Zeit rücken die Energien um das 3- bis 5-Fache zusammen
figure-p-willmore-11 = Abb. { $number }
    .title = Ein Schritt, dann Regularisierung
    .reports = Ein Schritt des Flusses und zwei nichtlineare Durchgänge vernetzen ein Gürteltier fast unmerklich neu.
    .expected = Eine andere Form, ein Ellipsoid mit umgeklappten Dreiecken: keines mehr, Verzerrung unter einem Drittel, um weniger als 1 % bewegt
figure-p-willmore-12-p0 = Abb. { $number }, p = 0
    .title = Volumen fest, p = 0
    .reports = Ein Hase mit festem Volumen wird für jedes p zur Sphäre, auf verschiedenen Wegen.
    .expected = Eine andere Form, ein Ellipsoid: eine Sphäre auf 2e-3, Volumen auf 1e-8
figure-p-willmore-12-p2 = Abb. { $number }, p = 2
    .title = Volumen fest, p = 2
    .reports = Ein Hase mit festem Volumen wird für jedes p zur Sphäre, auf verschiedenen Wegen.
    .expected = Eine andere Form, ein Ellipsoid: eine Sphäre auf 2e-3, Volumen auf 1e-8
figure-p-willmore-12-p4 = Abb. { $number }, p = 4
    .title = Volumen fest, p = 4
    .reports = Ein Hase mit festem Volumen wird für jedes p zur Sphäre, auf verschiedenen Wegen.
    .expected = Eine andere Form, ein Ellipsoid: eine Sphäre auf 2e-3, Volumen auf 1e-8
figure-flips-6 = Abb. { $number }, oben
    .title = Torus, ein Netz nach allen Kriterien
    .reports = Auf Punkten eines Torus führen alle drei Kriterien zu genau demselben Netz.
    .expected = Andere, so gewählte Punkte: je 203 Flips, ein Inhalt und ein W (nicht auf allen Punkten so)
figure-flips-6-curvature = Abb. { $number }, unten
    .title = Torus, Gaußsche Krümmung nach Unterteilung nach Loop
    .reports = Bilder der Gaußschen Krümmung der unterteilten Netze zeigen sie sichtbar glatter.
    .expected = Variation von K längs der Kanten unter dem 0.7-Fachen des Anfangs
figure-flips-7 = Abb. { $number }
    .title = Gesicht mit Falten
    .reports = Nach Flächeninhalt oder lokalisierter Energie erreicht ein Gesicht ein kleineres W als nach der Willmore-Energie.
    .expected = Ein künstliches Gesicht: W nach Inhalt und nach lokalisierter Energie unter W nach sich selbst
    .shortfall = Auf diesem Gesicht enden Flips nach der Willmore-Energie tiefer. Welches Ende tiefer liegt, hängt vom Netz ab: Jedes ist nur ein lokales Minimum.
figure-flips-8 = Abb. { $number }
    .title = Kopf mit Ohren
    .reports = Flächeninhalt und lokalisierte Energie fallen miteinander, und auch W.
    .expected = Eine andere Form als der Hase: im Inhalt Flächeninhalt ≤ lokalisiert < Willmore, in W beide darunter
figure-flips-8-volume = Abb. { $number }, Ohren
    .title = Ohren verlieren Volumen
    .reports = Nach dem Flächeninhalt verlieren schmale Teile wie die Ohren des Hasen Volumen.
    .expected = Ein Kopf mit Ohren verliert 0.2 bis 2 % seines Volumens
figure-curvature-5-1-cylinder = Abb. { $number }
    .title = Zylinder wiederhergestellt
    .reports = Ein Zylinder mit fehlenden Teilen wird in 100 Schritten richtig wiederhergestellt.
    .expected = Der Zylinder vom Radius 1 auf 0.0005, in Ruhe
figure-curvature-5-1-sphere = Abb. { $number }
    .title = Sphäre wiederhergestellt
    .reports = Eine Sphäre mit acht Öffnungen wird in 350 Schritten vollkommen wiederhergestellt.
    .expected = Die Sphäre vom Radius 1 auf 0.0005, in Ruhe
figure-curvature-5-4 = Abb. { $number }
    .title = Ecken eines Dodekaeders interpoliert
    .reports = Eine glatte Fläche interpoliert die Ecken eines Dodekaeders.
    .expected = Die Sphäre vom Radius 1 auf 0.001, in Ruhe
figure-curvature-5-2-two = Abb. { $number }
    .title = Zwei Rohre verbunden
    .reports = Rohre werden vom Fluss sechster Ordnung in 5 Schritten glatt verbunden.
    .expected = Koaxiale Rohre vom Radius 0.5: der Zylinder dazwischen auf 1e-3 davon, in Ruhe
figure-curvature-5-2-three = Abb. { $number }
    .title = Drei Rohre verbunden
    .reports = Rohre werden vom Fluss sechster Ordnung in 50 Schritten glatt verbunden.
    .expected = In Ruhe, der Sprung der Krümmung höchstens das 0.45-Fache dessen bei Oberflächendiffusion
figure-curvature-5-2-six = Abb. { $number }
    .title = Sechs Rohre verbunden
    .reports = Rohre werden vom Fluss sechster Ordnung in 10 Schritten glatt verbunden.
    .expected = In Ruhe, der Sprung der Krümmung höchstens das 0.45-Fache dessen bei Oberflächendiffusion
figure-curvature-5-3 = Abb. { $number }
    .title = Löcher gefüllt
    .reports = Löcher eines Kopfes werden glatt gefüllt, mit stetiger Krümmung an ihren Rändern.
    .expected = Eine Sphäre mit Löchern statt eines Kopfes: geschlossen, in Ruhe, und der Sprung der Krümmung an den Rändern unter 0.1
figure-curvature-5-5 = Abb. { $number }
    .title = Flüsse im Vergleich an einem Übergang
    .reports = Der Fluss sechster Ordnung schließt mit stetiger mittlerer Krümmung an, die vierter Ordnung nicht.
    .expected = Sprung höchstens das 0.45-Fache dessen bei Oberflächendiffusion und beim Willmore-Fluss
figure-curvature-5-6 = Abb. { $number }
    .title = Flüsse im Vergleich an einem Graphen
    .reports = Fluss nach der mittleren Krümmung und Willmore-Fluss sind nicht krümmungsstetig, der sechster Ordnung ist es.
    .expected = Die Funktion berichtigt: Sprung höchstens 0.06 und halb so groß wie bei den Flüssen vierter Ordnung, 0.9 und mehr beim Fluss nach der mittleren Krümmung
figure-volume-preserving-round = Satz, { $number }
    .title = Eine konvexe Fläche wird rund
    .reports = Der Fluss nach der mittleren Krümmung bei festem Volumen macht jede konvexe Fläche zur runden Sphäre gleichen Volumens.
    .expected = Eine Sphäre auf 2e-3, Volumen auf 1e-10, 36πV²/A³ gestiegen auf 0.99 und mehr
figure-eversion = Die Minimax-Umstülpung, { $number }
    .title = Die Sphäre, umgestülpt
    .reports = Eine Sphäre lässt sich ohne Knick durch sich selbst umstülpen (Smale, 1958). Sie muss dabei durch einen vierfachen Punkt und ∫H² = 16π (Max und Banchoff, 1981; Li und Yau, 1982); Morins Fläche nach Kusner hat genau so viel und fließt nach beiden Seiten zur Sphäre, indem sie sich weniger biegt.
    .expected = Beide Wege enden an einer runden Sphäre, ∫H² unter 1.005·4π; Volumen mit entgegengesetzten Vorzeichen, auf 1 % das der Kugel; an den Enden keine Durchdringungen; in jedem Schritt immersiert, kleinstes Produkt von Flächen- und Eckennormalen über 0.3
figure-eversion-fine = Die Minimax-Umstülpung, { $number }, feiner
    .title = Die Sphäre, umgestülpt, 5000 Ecken
    .reports = Eine Sphäre lässt sich ohne Knick durch sich selbst umstülpen (Smale, 1958); derselbe Film auf einem feineren Netz, das etwa zehnmal so lange braucht.
    .expected = Beide Wege enden an einer runden Sphäre, ∫H² unter 1.005·4π; Volumen mit entgegengesetzten Vorzeichen, auf 1 % das der Kugel; an den Enden keine Durchdringungen; in jedem Schritt immersiert, kleinstes Produkt von Flächen- und Eckennormalen über 0.3
figure-lawson-2 = ξ₂,₁, { $number }
    .title = Die am wenigsten gebogene Fläche mit zwei Henkeln
    .reports = Lawsons Minimalfläche ξ₂,₁ der 3-Sphäre hat den Inhalt 21,89, und so hat ihr Bild im Raum die Willmore-Energie 21,89. Nach Kusners Vermutung (1989) ist keine Fläche mit zwei Henkeln weniger gebogen; für einen Henkel haben es Marques und Neves bewiesen (2014).
    .expected = Am Ende zwei Henkel, ∫H² = 21,89 auf 0,7 %, der Flächeninhalt auf 1e-8 erhalten
figure-lawson-3 = ξ₃,₁, { $number }
    .title = Die am wenigsten gebogene Fläche mit drei Henkeln
    .reports = Lawsons ξ₃,₁ hat die Willmore-Energie 22,82. Die Reihe geht weiter gegen 8π: 8π(1 − ln 2/(2g + 2) − …) bei g Henkeln (Heller, Heller und Traizet, 2023).
    .expected = Am Ende drei Henkel, ∫H² = 22,82 auf 0,7 %, der Flächeninhalt auf 1e-8 erhalten
figure-knot-undone = Ein Knoten, { $number }
    .title = Ein Knoten löst sich
    .reports = Eine Immersion darf sich selbst durchdringen, und so lässt sich ein verknoteter Torus in einen ohne Knoten überführen. Von allen Tori ist der Clifford-Torus am wenigsten gebogen, ∫H² = 2π² (Marques und Neves, 2014).
    .expected = Am Ende ein Torus, ∫H² = 2π² auf 1 %, der sich unterwegs durchdrungen hat; der Flächeninhalt auf 1e-8 erhalten
figure-link-undone = Eine Verschlingung, { $number }
    .title = Eine Verschlingung löst sich
    .reports = Eine Immersion darf sich selbst durchdringen, und so nimmt von zwei verschlungenen Tori jeder die am wenigsten gebogene Form an, als wäre der andere nicht da: ∫H² = 2·2π².
    .expected = Am Ende zwei Tori, ∫H² = 4π² auf 1 %, die einander durchdringen; der Flächeninhalt auf 1e-8 erhalten

## Measured on a figure

figure-waiting = { $steps ->
    [rest] Laufen lassen, bis die Fläche zur Ruhe kommt.
    [0] So, wie sie dasteht.
   *[other] Laufen lassen, mindestens bis Schritt { $steps }.
}
figure-measuring = Wird gemessen …
measured-round = W { NUMBER($first, digits: 4) }π → { NUMBER($last, digits: 2) } in { $steps } Schritten, Abweichung von der Sphäre { NUMBER($off, digits: 2) }
measured-rest = W { NUMBER($last, digits: 2) } nach { $steps } Schritten, { $status }
measured-plane = W { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, aus der Ebene { NUMBER($off, digits: 2) }
measured-torus = W { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, Abweichung vom Torus { NUMBER($off, digits: 2) } %
measured-proportions = R/r { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, Abweichung vom Torus { NUMBER($off, digits: 2) } %
measured-energy = W { NUMBER($first, digits: 5) } → { NUMBER($last, digits: 4) }
measured-noise = W { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, Abstand × { $ratio }
measured-area-kept = ∫H² = { NUMBER($energy, digits: 4) }·4π, Abweichung { NUMBER($off, digits: 2) }, Drift { NUMBER($drift, digits: 1) }
measured-letter = Inhalt × { $area }, ∫|H|^p = { NUMBER($energy, digits: 4) } von dem der Sphäre, { $status }
measured-mended = umgeklappt { $firstInverted } → { $lastInverted }, Winkel { NUMBER($firstAngle, digits: 2) }° → { $lastAngle }°, Verzerrung { $firstDistortion } → { $lastDistortion }, bewegt { NUMBER($moved, digits: 2) } %, Volumen { NUMBER($volume, digits: 2) } %
measured-clifford = ∫H² = { NUMBER($energy, digits: 4) }·2π², v = { NUMBER($volume, digits: 4) }
measured-kept = ∫H² { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, Winkel { $firstAngle }° → { $lastAngle }°, Drift { NUMBER($drift, digits: 1) }, { $status }
measured-vesicle = ∫H² = { NUMBER($energy, digits: 4) }·4π bei v = { NUMBER($volume, digits: 6) }, { $status }
measured-genus = Geschlecht { $genus }, ∫H² { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) } = { NUMBER($energy, digits: 4) }·8π, { $status }
measured-refinement = { NUMBER($coarse, digits: 5) }, { NUMBER($middle, digits: 5) }, { NUMBER($fine, digits: 5) }: Verhältnis { $ratio }
measured-refinement-apart = { NUMBER($coarse, digits: 5) }, { NUMBER($middle, digits: 5) }, { NUMBER($fine, digits: 5) }: Verhältnis { $ratio }, nicht zur selben Zeit
measured-ball = Abweichung { NUMBER($off, digits: 2) }, Drift { NUMBER($drift, digits: 1) }, { $steps } Schritte, { $status }
measured-isoperimetric = 36πV²/A³ { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 5) }, Abweichung { NUMBER($off, digits: 2) }, Drift { NUMBER($drift, digits: 1) }, { $steps } Schritte, { $status }
measured-eversion = ∫H²/4π { NUMBER($firstEnergy, digits: 5) } ← { NUMBER($halfway, digits: 4) } → { NUMBER($lastEnergy, digits: 5) }, V durch das der Kugel { NUMBER($firstVolume, digits: 4) } und { NUMBER($lastVolume, digits: 4) }, Durchdringungen { $firstCrossings } ← { $crossings } → { $lastCrossings }, kleinstes Produkt von Normalen { NUMBER($alignment, digits: 2) }
measured-lawson = Geschlecht { $genus }, ∫H² { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 5) }, erwartet { NUMBER($least, digits: 4) }: { NUMBER($off, digits: 2) } %; Drift { NUMBER($drift, digits: 1) }, Winkel { NUMBER($angle, digits: 2) }°, { $status }
measured-undone = ∫H² { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 5) } mal { $tubes }·2π²; höchstens { $crossings } Durchdringungen, am Ende { $left }; kleinstes Produkt von Normalen { NUMBER($alignment, digits: 2) }, Drift { NUMBER($drift, digits: 1) }, { $status }
measured-flips = Inhalt/Willmore/lokalisiert: { $areaFlips }/{ $willmoreFlips }/{ $localisedFlips } Flips, Inhalt { NUMBER($area, digits: 5) }/{ NUMBER($willmoreArea, digits: 5) }/{ NUMBER($localisedArea, digits: 5) }, W { NUMBER($areaCircle, digits: 4) }/{ NUMBER($willmoreCircle, digits: 4) }/{ NUMBER($localisedCircle, digits: 4) }
measured-variation = Σ|ΔK| { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }
measured-lost = { $lost } % verloren
measured-recovered = Abweichung { NUMBER($first, digits: 2) } → { NUMBER($last, digits: 2) } in { $steps } Schritten, { $status }
measured-tube = Abweichung { NUMBER($off, digits: 2) }, Sprung { NUMBER($jump, digits: 2) } in { $steps } Schritten, { $status }
measured-holes = { $loops } Randkurven übrig, { $status } in { $steps } Schritten, Sprung { NUMBER($jump, digits: 2) }
measured-jumps = mittlere Krümmung { $meanCurvature }, Oberflächendiffusion { $surfaceDiffusion }, Willmore { $willmore }, Variation der mittleren Krümmung { $mmcv }
measured-incomplete = Noch ist nicht alles davon gelaufen.

measured-ready = bereit
measured-converged = konvergiert
measured-step-limit = an der Schrittgrenze
measured-stalled = stecken geblieben
measured-singular = singulär
measured-collapsed = kollabiert
measured-failed = gescheitert

## Das Phasendiagramm der Vesikel

phases = Vesikel: Phasendiagramm
phases-hint = Das kleinste ∫H² über dem reduzierten Volumen v = 6√π V/A^(3/2), auf drei Zweigen von Formen mit festem Flächeninhalt und Volumen (Seifert, Berndl und Lipowsky, 1991). Gestreckte biegen sich am wenigsten über 0,651, flache bis hinab zu 0,592, darunter Stomatozyten. Jeder Punkt wird hier berechnet; ein Klick zeigt seine Fläche.
phases-run = Formen berechnen
phases-count = { $count } von { $of } Formen
phase-of = Zweig
phase-expected = Erwartet
phase-branch = { $branch ->
    [prolate] gestreckt
    [oblate] flach
   *[stomatocyte] Stomatozyt
}
phase-point = Die Form zeigen: { phase-branch }, Volumen { $volume }, ∫H²/4π = { $energy }

## Beispiele, und worauf zu achten ist

sample-icosahedron-shows = Wird zur runden Sphäre; W beginnt bei genau 60π und fällt auf null (Abbildung 6).
sample-bumpy-sphere-shows = Beulen schmelzen, kurze zuerst, bis die Sphäre rund und W null ist.
sample-coarse-torus-shows = Rundet sich, dann nähert sich sein Verhältnis langsam R/r = √2 (Abbildung 8).
sample-clifford-torus-shows = Das Minimum unter den Tori: W/2 liegt bei 2π², und der Fluss bewegt ihn kaum.
sample-pipe-shows = Beide Enden behalten Lage und Tangente; der Bogen dazwischen entspannt sich (Abbildung 9).
sample-six-sided-hole-shows = Füllt ein sechseckiges Loch glatt, von einem harmonischen ersten Ansatz aus (Abbildung 10).
sample-scar-shows = Nur der beschädigte Flicken bewegt sich und schließt sich ohne Naht (Abbildung 11).
sample-noisy-scan-shows = Zehn Schritte nehmen das Rauschen weg und lassen die Form (Abbildung 12).
sample-trefoil-shows = Ein verknoteter Schlauch wird dicker; lösen kann er sich nicht.
sample-vesicle-shows = Bei festem Flächeninhalt wird das Volumen auf 0.6 der Kugel gesenkt: eine bikonkave Scheibe, wie ein rotes Blutkörperchen (p-Willmore, Abbildung 6).
sample-blob-shows = Ohne jede Symmetrie am Anfang endet auch er als bikonkave Scheibe, als elliptische (p-Willmore, Abbildung 6).
sample-spheroid-shows = Wird rund, während das Volumen bleibt: Der Flächeninhalt fällt, und 36πV²/A³ steigt auf 1.
sample-letter-c-shows = Rundet sich mit p = 2 zur Sphäre; schrumpft mit p = 0, wächst mit p = 4 (p-Willmore, Abbildung 2).
sample-thin-torus-shows = Verdickt sich zum Clifford-Torus: ∫H² fällt auf 2π² (p-Willmore, Abbildung 4).
sample-torus-knot-shows = Bei festem Inhalt und Volumen; ohne Regularisierung entartet das Netz (p-Willmore, Abbildung 5).
sample-bad-mesh-shows = Dreiecke sind umgeklappt; „Dreiecke ausgleichen“ heilt sie, ohne die Form zu ändern (p-Willmore, Abbildungen 3, 7 und 11).
sample-trefoil-kept-shows = Ein dicker verknoteter Schlauch kommt auf einem Plateau von ∫H² zur Ruhe (p-Willmore, Abbildung 9).
sample-trefoil-tube-shows = Ein verknoteter Schlauch geht durch sich hindurch und endet als Clifford-Torus: ∫H² = 2π² (Pinkall; Marques und Neves).
sample-linked-tubes-shows = Zwei verschlungene Schläuche gehen durcheinander hindurch und enden als zwei Clifford-Tori: ∫H² = 4π².
sample-bumps-kept-shows = Rundet sich, ohne zu wachsen oder zu schrumpfen (p-Willmore, Abbildung 1).
sample-ellipsoid-p-shows = Am Ende eine Sphäre, für jeden Exponenten p auf anderem Weg (p-Willmore, Abbildung 12).
sample-cylinder-gaps-shows = Eingesunkene Flicken heben sich zurück zum Zylinder: Seine mittlere Krümmung ist konstant (Variation der Krümmung, Abbildung 5.1).
sample-sphere-openings-shows = Acht ebene Deckel werden zur Sphäre, aus der sie geschnitten sind (Variation der Krümmung, Abbildung 5.1).
sample-two-tubes-shows = Ein Flicken, der beide verbindet, wird zum Zylinder dazwischen (Variation der Krümmung, Abbildung 5.2).
sample-three-tubes-shows = Der Übergang schließt mit stetiger Krümmung an die Rohre an; vergleichen Sie alle vier Flüsse (Variation der Krümmung, Abbildung 5.2).
sample-six-tubes-shows = Entlang aller drei Achsen (Variation der Krümmung, Abbildung 5.2).
sample-holed-scan-shows = Was der Scanner nicht sah, wird gefüllt und geglättet (Variation der Krümmung, Abbildung 5.3).
sample-holed-sphere-shows = Löcher werden trianguliert, neu vernetzt, vorgefüllt und geglättet: wieder die Sphäre (Variation der Krümmung, Abbildung 5.3).
sample-dodecahedron-shows = Zwanzig Punkte werden interpoliert: die Sphäre durch sie (Variation der Krümmung, Abbildung 5.4).
sample-four-bumps-shows = Nur der Fluss sechster Ordnung schließt mit stetiger mittlerer Krümmung an: Achten Sie auf den Sprung (Variation der Krümmung, Abbildungen 5.5 und 5.6; die Funktion berichtigt, exp(−27/16 …)).
sample-sampled-torus-shows = Jede Zelle ist längs einer der Diagonalen zerschnitten; Flips räumen das auf. Hier enden die drei Kriterien beim selben Netz (Kantenflips, Abbildung 6).
sample-uneven-torus-shows = Hier führen Flächeninhalt und lokalisierte Energie zum selben Netz, die Willmore-Energie zu einem anderen.
sample-creased-face-shows = Lange senkrechte Kanten machen Falten; Flips glätten die meisten (Kantenflips, Abbildung 7).
sample-eared-head-shows = Nach Flächeninhalt oder lokalisierter Energie endet W tiefer als nach sich selbst, und die Ohren verlieren Volumen (Kantenflips, Abbildung 8).
sample-counterexample-shows = Der Flip dieser Kante hebt den Flächeninhalt und senkt die lokalisierte Energie: f_a = 15/2 − 2√2 − √89/2 = −0.0454, f_l = +0.0068.
sample-moebius-shows = Eine Seite und ein Rand; die Energie braucht keine Orientierung.
sample-klein-bottle-shows = Geschlossen und einseitig: Sie hat kein Volumen, aber eine Energie.
sample-saddle-shows = Mit freiem Rand wird er zu einem konvexen Stück der Ebene; mit festem bleibt er ein Sattel (Abbildung 7).
sample-genus-4-shows = Ihre Henkel runden sich; ∫H² strebt unter 8π (p-Willmore, Abbildung 8).
sample-morin-shows = Die Hälfte einer umgestülpten Sphäre: von 16π durch sich selbst zur runden Sphäre (Kusner).
sample-morin-fine-shows = Dieselbe Hälfte der Umstülpung auf einem feineren Netz.
sample-boy-shows = Eine projektive Ebene, einseitig, und die am wenigsten gebogene im Raum: ∫H² = 12π (Bryant, Kusner).
sample-cyclide-shows = Ein Möbius-Bild des Clifford-Torus, mit derselben Energie: W/2 liegt nahe 2π².
sample-inverted-catenoid-shows = Zwei Blätter, die sich in einem Punkt berühren: ∫H² = 8π, wie bei jeder invertierten Minimalfläche mit zwei Enden.
sample-lawson-two-handles-shows = Fließt zu Lawsons ξ₂,₁, deren Symmetrien und Großkreise sie hat: ∫H² = 21,89, so wenig wie keine andere bekannte mit zwei Henkeln.
sample-lawson-three-handles-shows = Fließt zu Lawsons ξ₃,₁: ∫H² = 22,82, so wenig wie keine andere bekannte mit drei Henkeln.
sample-rough-mesh-shows = Ein Durchgang von „Dreiecke ausgleichen“ genügt hier (p-Willmore, Abbildung 7).
sample-range-scan-shows = So groß wie der der Arbeit, mit ebenso vielen Löchern; hundert Schritte beginnen auch Merkmale wegzunehmen (Abbildung 12).

## Neue Dreiecke zwischen Schritten

step-remeshed = Schritt { $step }, nach neuem Vernetzen: Energie { NUMBER($before, digits: 5) } zu { NUMBER($after, digits: 5) }
