# Beschriftung der Schublade, die das erste Bild nicht braucht.

## Die Gleichung

equation-energy = Energie
equation-flow = Gleichung
symbols = Die Zeichen, wie sie jetzt sind
symbols-beta = Winkel zwischen den Umkreisen der Dreiecke an der Kante ij
symbols-epsilon = rundet die Kegelspitze bei Winkel 0 ab
symbols-p = Exponent
symbols-mean = mittlere Krümmung, (κ₁ + κ₂)/2, positiv auf einer Kugel
symbols-gauss = Gaußsche Krümmung
symbols-normal = äußere Normale
symbols-spontaneous = spontane Krümmung, ohne Einheit
symbols-tension = Spannung, die den Flächeninhalt hält
symbols-pressure = Druck, der das Volumen hält oder führt
symbols-mass = Masse einer Ecke
symbols-matrix = zweite Variation der Kreisenergie, Stern für Stern semidefinit gemacht
symbols-dt = Schrittweite
symbols-tau = Schrittweite ohne Einheit
symbols-edge = mittlere Kantenlänge am Anfang
symbols-size = √(A/4π) am Anfang
symbols-localised = lokale Energien vor und nach dem Flip

## Verfeinerungsstudie

study-of = Von
study-sample = Das Beispiel, an seinem Anfang
study-surface = Die Fläche, wie sie jetzt ist
study-run = Messen
study-cancel = Abbrechen
study-crashed = Die Studie brach unerwartet ab ({ $reason }).
study-preparing = Die Fläche wird vorbereitet …
study-measuring = Auflösung { $level } wird gemessen …
study-order = Ordnung { $order }
study-smooth = Glatt
study-refined-by = { $refinedBy ->
    [sampled] Die glatte Form, bei jeder Auflösung neu abgetastet; höchstens { $most } Ecken.
    [polyhedron] Das Polyeder, seine Seiten jedes Mal geviertelt; höchstens { $most } Ecken.
   *[loop] Die Grenzfläche von Loops Schema mit diesem Netz als Steuernetz, die etwas innerhalb liegt; höchstens { $most } Ecken.
}
trend-name = { $quantity ->
    [area] Der Flächeninhalt
    [circle] W/2
    [cotangent] ∫H² durch Kotangens
    [fitted] ∫H² durch quadratische Anpassung
   *[power] ∫|H|^{ $p }
}
trend-symbol = { $quantity ->
    [area] A
    [circle] W/2
    [cotangent] ∫H² cot
    [fitted] ∫H² fit
   *[power] ∫|H|^p
}
trend = { $tendency ->
    [exact] { $name } stimmt bei jeder Auflösung, bis auf Rundung.
    [converges] { $name } strebt gegen den glatten Wert { NUMBER($smooth, digits: 5) }; beobachtete Ordnung { NUMBER($order, digits: 2) }.
    [nears] { $name } strebt gegen ∫(H²−K) dA, { NUMBER($smooth, digits: 5) } durch quadratische Anpassung auf dem feinsten Netz.
    [settles] { $name } beruhigt sich; beobachtete Ordnung { NUMBER($order, digits: 2) }.
    [elsewhere] { $name } strebt nicht gegen den glatten Wert { NUMBER($smooth, digits: 5) }, sondern gegen etwa das { $ratio }-fache.
    [elsewhereThanZero] { $name } beruhigt sich, aber nicht beim glatten Wert { NUMBER($smooth, digits: 5) }.
    [diverges] { $name } beruhigt sich nicht: jede Verfeinerung ändert es so sehr wie die davor.
   *[unknown] Über { $name } sagen zwei Auflösungen nicht mehr.
}
study-polyhedron = Die Krümmung eines Polyeders sitzt in seinen Kanten: geteilte Seiten lösen sie immer schärfer auf, und jede Willmore-Energie wächst wie 1/h.
study-lattice = Die Kreiswinkel-Energie strebt nur dann gegen die glatte, wenn die Kanten in einem rechtwinkligen Gitter den Krümmungslinien folgen. Auf anderen Gittern ist ihr Grenzwert größer, und wo Dreiecke nicht Delaunay sind, hat sie keinen (Bobenko und Schröder 2005, Abschnitt 2). Zwischen Schritten vergleichen, nicht zwischen Netzen.
study-minimisers = Dass Werte auf gegebenen Netzen konvergieren, heißt nicht, dass Minimierer konvergieren: jede bisher vorgeschlagene stückweise lineare Willmore-Energie zu minimieren, führt nicht zu einer Lösung der glatten Aufgabe (Chen, Yu, Brogan, Kusner, Yang und Zigerelli, arXiv 1901.09990).

## Die Vermutung

conjecture-holds = { $against ->
    [0] Auf diesem Netz gilt sie für alle { $total } Kanten: Inhalt und lokale Energie steigen oder fallen gemeinsam.
   *[other] Auf diesem Netz steigen oder fallen Inhalt und lokale Energie bei { $percent } % von { $total } Kanten gemeinsam, bei { $against } nicht.
}
conjecture-plot = Was ein Flip jeder Kante gewinnt: Inhalt nach rechts, lokale Energie nach oben
both-fall = Beide fallen
neither-falls = Keine fällt
only-area = Nur der Inhalt fällt
only-localised = Nur die lokale Energie fällt
counterexamples = Gegenbeispiele
counterexample = Kante { $i }–{ $j }: f_a { $area }, f_l { $localised }
quad = Viereck
quad-gained = { $gained } von { $area }
quad-fold = Winkel zwischen den Seiten
lab-run = Vierecke ziehen
lab-stop = Halt
lab-found = { $total } zufällige Tetraeder, { $against } dagegen: { $areaOnly } senken nur den Inhalt, { $localisedOnly } nur die lokale Energie.
lab-total = Gezogen
lab-against = Dagegen

## Ein Spalt, und wie gezählt wird

found-gap = Ein Spalt
    .hint = Zwei Ränder laufen nebeneinander, näher als eine halbe Kante. Innerhalb dieser Länge verschweißt werden sie eins; das lässt sich rückgängig machen.
weld-length = Länge
weld = Verschweißen
counted-from = ab { $first } gezählt

# Why it stands where it does.
why-heading = Warum hat es angehalten?
why-show = Zeigen
nothing-wrong = Alles in Ordnung. Es wurde angehalten, und Abspielen geht von hier weiter.
what-measures = Was die Energie misst
why-ended = { $ended }: { $reason }.
next = Weiter: { $name }
