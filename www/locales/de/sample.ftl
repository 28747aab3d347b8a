# Samples: their names, and what to look for.

## Samples, and what to look for

sample-icosahedron = Unterteiltes Ikosaeder
    .shows = Wird zur runden Sphäre; W beginnt bei genau 60π und fällt auf null (Abbildung 6).
sample-bumpy-sphere = Beulige Sphäre
    .shows = Beulen schmelzen, kurze zuerst, bis die Sphäre rund und W null ist.
sample-coarse-torus = Unterteilter grober Torus
    .shows = Rundet sich, dann nähert sich sein Verhältnis langsam R/r = √2 (Abbildung 8).
sample-clifford-torus = Clifford-Torus
    .shows = Das Minimum unter den Tori: W/2 liegt bei 2π², und der Fluss bewegt ihn kaum.
sample-pipe = Rohr mit eingespannten Enden
    .shows = Beide Enden behalten Lage und Tangente; der Bogen dazwischen entspannt sich (Abbildung 9).
sample-six-sided-hole = Sechsseitiges Loch
    .shows = Füllt ein sechseckiges Loch glatt, von einem harmonischen ersten Ansatz aus (Abbildung 10).
sample-scar = Narbe auf einem Stein
    .shows = Nur der beschädigte Flicken bewegt sich und schließt sich ohne Naht (Abbildung 11).
sample-noisy-scan = Verrauschter Scan
    .shows = Zehn Schritte nehmen das Rauschen weg und lassen die Form (Abbildung 12).
sample-trefoil = Kleeblattknoten
    .shows = Ein verknoteter Schlauch wird dicker; lösen kann er sich nicht.
sample-vesicle = Vesikel mit weniger Volumen
    .shows = Bei festem Flächeninhalt wird das Volumen auf 0.6 der Kugel gesenkt: eine bikonkave Scheibe, wie ein rotes Blutkörperchen (p-Willmore, Abbildung 6).
sample-blob = Klumpen mit weniger Volumen
    .shows = Ohne jede Symmetrie am Anfang endet auch er als bikonkave Scheibe, als elliptische (p-Willmore, Abbildung 6).
sample-spheroid = Rotationsellipsoid mit Achsen 2, 1, 1
    .shows = Wird rund, während das Volumen bleibt: Der Flächeninhalt fällt, und 36πV²/A³ steigt auf 1.
sample-letter-c = Buchstabe C
    .shows = Rundet sich mit p = 2 zur Sphäre; schrumpft mit p = 0, wächst mit p = 4 (p-Willmore, Abbildung 2).
sample-thin-torus = Dünner Torus
    .shows = Verdickt sich zum Clifford-Torus: ∫H² fällt auf 2π² (p-Willmore, Abbildung 4).
sample-torus-knot = Torusknoten
    .shows = Bei festem Inhalt und Volumen; ohne Regularisierung entartet das Netz (p-Willmore, Abbildung 5).
sample-bad-mesh = Ellipsoid, schlecht vernetzt
    .shows = Dreiecke sind umgeklappt; „Netz jetzt regularisieren“ heilt sie, ohne die Form zu ändern (p-Willmore, Abbildungen 3, 7 und 11).
sample-trefoil-kept = Kleeblattknoten, Inhalt und Volumen fest
    .shows = Ein dicker verknoteter Schlauch kommt auf einem Plateau von ∫H² zur Ruhe (p-Willmore, Abbildung 9).
sample-bumps-kept = Beulige Sphäre, Inhalt fest
    .shows = Rundet sich, ohne zu wachsen oder zu schrumpfen (p-Willmore, Abbildung 1).
sample-ellipsoid-p = Ellipsoid, Volumen fest, p = 4
    .shows = Am Ende eine Sphäre, für jeden Exponenten p auf anderem Weg (p-Willmore, Abbildung 12).
sample-cylinder-gaps = Zylinder mit vier Lücken
    .shows = Eingesunkene Flicken heben sich zurück zum Zylinder: Seine mittlere Krümmung ist konstant (Variation der Krümmung, Abbildung 5.1).
sample-sphere-openings = Sphäre mit acht Öffnungen
    .shows = Acht ebene Deckel werden zur Sphäre, aus der sie geschnitten sind (Variation der Krümmung, Abbildung 5.1).
sample-two-tubes = Zwei Rohre verbunden
    .shows = Ein Flicken, der beide verbindet, wird zum Zylinder dazwischen (Variation der Krümmung, Abbildung 5.2).
sample-three-tubes = Drei Rohre verbunden
    .shows = Der Übergang schließt mit stetiger Krümmung an die Rohre an; vergleichen Sie alle vier Flüsse (Variation der Krümmung, Abbildung 5.2).
sample-six-tubes = Sechs Rohre verbunden
    .shows = Entlang aller drei Achsen (Variation der Krümmung, Abbildung 5.2).
sample-holed-scan = Scan mit gefüllten Löchern
    .shows = Was der Scanner nicht sah, wird gefüllt und geglättet (Variation der Krümmung, Abbildung 5.3).
sample-holed-sphere = Sphäre mit gefüllten Löchern
    .shows = Löcher werden trianguliert, neu vernetzt, vorgefüllt und geglättet: wieder die Sphäre (Variation der Krümmung, Abbildung 5.3).
sample-dodecahedron = Dodekaeder, Ecken fest
    .shows = Zwanzig Punkte werden interpoliert: die Sphäre durch sie (Variation der Krümmung, Abbildung 5.4).
sample-four-bumps = Vier Hügel, Flüsse im Vergleich
    .shows = Nur der Fluss sechster Ordnung schließt mit stetiger mittlerer Krümmung an: Achten Sie auf den Sprung (Variation der Krümmung, Abbildungen 5.5 und 5.6; die Funktion berichtigt, exp(−27/16 …)).
sample-sampled-torus = Abgetasteter Torus
    .shows = Jede Zelle ist längs einer der Diagonalen zerschnitten; Flips räumen das auf. Hier enden die drei Kriterien beim selben Netz (Kantenflips, Abbildung 6).
sample-uneven-torus = Abgetasteter Torus, ungleichmäßig
    .shows = Hier führen Flächeninhalt und lokalisierte Energie zum selben Netz, die Willmore-Energie zu einem anderen.
sample-creased-face = Gesicht mit Falten
    .shows = Lange senkrechte Kanten machen Falten; Flips glätten die meisten (Kantenflips, Abbildung 7).
sample-eared-head = Kopf mit Ohren
    .shows = Nach Flächeninhalt oder lokalisierter Energie endet W tiefer als nach sich selbst, und die Ohren verlieren Volumen (Kantenflips, Abbildung 8).
sample-counterexample = Gegenbeispiel
    .shows = Der Flip dieser Kante hebt den Flächeninhalt und senkt die lokalisierte Energie: f_a = 15/2 − 2√2 − √89/2 = −0.0454, f_l = +0.0068.
sample-moebius = Möbiusband
    .shows = Eine Seite und ein Rand; die Energie braucht keine Orientierung.
sample-klein-bottle = Kleinsche Flasche
    .shows = Geschlossen und einseitig: Sie hat kein Volumen, aber eine Energie.
sample-saddle = Sattel, Rand frei
    .shows = Mit freiem Rand wird er zu einem konvexen Stück der Ebene; mit festem bleibt er ein Sattel (Abbildung 7).
sample-genus-4 = Fläche mit vier Henkeln
    .shows = Ihre Henkel runden sich; ∫H² strebt unter 8π (p-Willmore, Abbildung 8).
sample-morin = Morins Fläche, angestoßen
    .shows = Die Hälfte einer umgestülpten Sphäre: von 16π durch sich selbst zur runden Sphäre (Kusner).
sample-morin-fine = Morins Fläche, angestoßen, 5000 Ecken
    .shows = Dieselbe Hälfte der Umstülpung auf einem feineren Netz.
sample-boy = Boys Fläche
    .shows = Eine projektive Ebene, einseitig, und die am wenigsten gebogene im Raum: ∫H² = 12π (Bryant, Kusner).
sample-cyclide = Zyklide von Dupin
    .shows = Ein Möbius-Bild des Clifford-Torus, mit derselben Energie: W/2 liegt nahe 2π².
sample-inverted-catenoid = Invertiertes Katenoid
    .shows = Zwei Blätter, die sich in einem Punkt berühren: ∫H² = 8π, wie bei jeder invertierten Minimalfläche mit zwei Enden.
sample-rough-mesh = Ellipsoid, verzerrte Dreiecke
    .shows = Ein Durchgang von „Netz jetzt regularisieren“ genügt hier (p-Willmore, Abbildung 7).
sample-range-scan = Verrauschter Scan, 38 000 Ecken
    .shows = So groß wie der der Arbeit, mit ebenso vielen Löchern; hundert Schritte beginnen auch Merkmale wegzunehmen (Abbildung 12).

## Shelves of samples

group-closed = Geschlossene Flächen
group-tubes = Rohre und Knoten
group-boundary = Mit Rand
group-repair = Reparatur
group-flips = Kantenflips
