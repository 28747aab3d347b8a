# Netze, Formen, lineare Gleichungssysteme, Füllen und Regularisieren: src/mesh, src/linalg, src/remesh.

## Was keine Fläche ist

mesh-vertex-out-of-range = Facette { $face } benutzt Ecke { $vertex }, es gibt aber nur { $vertices } Ecken
    .hint = Die Datei ist beschädigt oder abgeschnitten: Exportieren Sie sie neu aus dem Programm, aus dem sie stammt.
mesh-non-finite-vertex = Ecke { $vertex } hat eine Koordinate, die keine endliche Zahl ist
    .hint = Entfernen Sie die Ecke in einem Netzeditor, oder geben Sie ihr eine Lage.
mesh-non-manifold-edge = die Kante zwischen den Ecken { $a } und { $b } hat { COUNT($faces) } Facetten ({ LIST($faces, most: 6) }){ $others ->
    [0] {""}
    [one] ; eine weitere Kante ist ebenso
   *[other] ; { $others } weitere Kanten sind ebenso
}{ $first ->
    [1] {" "}(gezählt ab 1, wie in der Datei)
   *[other] {""}
}
    .hint = Eine Fläche hat an einer Kante höchstens zwei Facetten. Eine Reparatur lässt kleine Blätter weg, die an einer solchen Kante hängen, und schneidet andere los.
mesh-no-faces = es gibt keine Facette mit drei verschiedenen Ecken und einem Flächeninhalt
    .hint = Prüfen Sie, ob die Datei eine Fläche enthält und nicht nur Punkte oder Linien.
mesh-too-large = { $count } Ecken von Facetten sind mehr, als 32-Bit-Indizes benennen können
    .hint = Vereinfachen Sie das Netz zuerst; etwa eine Million Facetten sind praktikabel.

## Was repariert wurde

repair-degenerate-faces = Weggelassen: { $count ->
    [one] { $count } entartete Facette (mit wiederholter Ecke)
   *[other] { $count } entartete Facetten (mit wiederholter Ecke)
}, zuerst Facette { $face }{ $first ->
    [1] {""} (ab 1 gezählt, wie in der Datei)
   *[other] {""}
}.
repair-bridged-faces = In Dreiecke zerlegt: { $count ->
    [one] { $count } Facette, die eine Ecke zweimal hat
   *[other] { $count } Facetten, die eine Ecke zweimal haben
}, wie um ein Loch.
repair-spiked-faces = Abgeschnitten, wo { $count ->
    [one] { $count } Facette
   *[other] { $count } Facetten
} zu einer Ecke hin und zurück { $count ->
    [one] läuft
   *[other] laufen
}.
repair-duplicate-faces = Weggelassen: { $count ->
    [one] { $count } Facette
   *[other] { $count } Facetten
} auf denselben Ecken wie eine frühere Facette.
repair-split-vertices = Aufgeteilt: { $count ->
    [one] { $count } nicht-mannigfaltige Ecke
   *[other] { $count } nicht-mannigfaltige Ecken
}, wo sich mehrere Blätter in einem Punkt berühren, in eine Ecke je Blatt ({ LIST($vertices, most: 5) }{ $first ->
    [1] {"; "}gezählt ab 1, wie in der Datei
   *[other] {""}
}).
repair-flat-pieces = Weggelassen: { $count ->
    [one] { $count } Facette
   *[other] { $count } Facetten
} in Stücken ohne Flächeninhalt.
repair-unused-vertices = Weggelassen, da von keiner Facette benutzt: { $count ->
    [one] { $count } Ecke
   *[other] { $count } Ecken
}.
repair-one-sided = { $count ->
    [one] { $count } Komponente
   *[other] { $count } Komponenten
} ohne einheitliche Orientierung (wie ein Möbiusband); Flüsse, die keine Normale brauchen, gehen trotzdem.
repair-turned-faces = Den Nachbarn entsprechend umgedreht: { $count ->
    [one] { $count } Facette
   *[other] { $count } Facetten
}.
repair-inside-out = Die Fläche war umgestülpt (negatives Volumen): Alle Facetten wurden umgedreht.
repair-turned-parts = Umgedreht: { $count ->
    [one] { $count } geschlossener Teil, der umgestülpt war
   *[other] { $count } geschlossene Teile, die umgestülpt waren
}.

repaired-uncrossed = In die richtige Reihenfolge gebracht: die Ecken { $count ->
    [one] eines Vierecks
   *[other] von { $count } Vierecken
} mit gekreuzten Seiten.
repaired-doubled-faces = Weggelassen: { $count ->
    [one] { $count } Facette, die
   *[other] { $count } Facetten, die
} genau auf einem früheren Blatt { $count ->
    [one] liegt
   *[other] liegen
}.
repaired-welded = Verschweißt: { $count ->
    [one] { $count } Randecke mit einer anderen
   *[other] { $count } Randecken mit anderen
} am selben Ort, wo das die Fläche schließt.
repaired-collapsed-edges = Zusammengezogen: { $count ->
    [one] { $count } Kante ohne Länge, mit den Facetten an ihr
   *[other] { $count } Kanten ohne Länge, mit den Facetten an ihnen
}.
repaired-flat-faces = Weggelassen: { $count ->
    [one] { $count } Dreieck
   *[other] { $count } Dreiecke
} ohne Flächeninhalt; was das öffnete, ist geschlossen.
repaired-inserted = Eingefügt: { $count ->
    [one] { $count } Ecke in die Kante, auf der sie liegt
   *[other] { $count } Ecken in die Kanten, auf denen sie liegen
}.
repaired-fins = Weggelassen: { $count ->
    [one] { $count } Facette
   *[other] { $count } Facetten
} kleiner Blätter, die an einer Kante zweier anderer Facetten hängen.
repaired-cut-edges = Aufgeschnitten: { $count ->
    [one] { $count } Kante mit mehr als zwei Facetten
   *[other] { $count } Kanten mit mehr als zwei Facetten
}; jedes Blatt hat nun seine eigene.
repaired-doubled-edges = Verdoppelt: { $count ->
    [one] { $count } Kante mit mehr als zwei Facetten, die kein Schnitt trennt; die Blätter dort haben in ihrer Mitte
   *[other] { $count } Kanten mit mehr als zwei Facetten, die kein Schnitt trennt; die Blätter dort haben in der Mitte
} je eine eigene Ecke.
repaired-walls = Weggelassen: { $count ->
    [one] { $count } Facette einer inneren Wand, ohne die
   *[other] { $count } Facetten innerer Wände, ohne die
} die Fläche außen herum geschlossen ist.

## Unterteilung

subdivision-not-a-triangle = Facette { FACE($face) } hat { $degree } Ecken; Unterteilung braucht Dreiecke
    .hint = Triangulieren Sie das Netz zuerst.
subdivision-non-manifold-edge = Kante { VERTEX($a, bare: 1) }-{ VERTEX($b) } hat mehr als zwei Facetten
    .hint = Trennen Sie die Fläche zuerst längs dieser Kante.

## Formen der Beispiele

shape-unknown-shape = es gibt keine Form `{ $name }`
    .hint = Die Formen sind { $known }.
shape-unknown-parameter = die Form `{ $shape }` hat keinen Parameter `{ $name }`
    .hint = { COUNT($known) ->
        [0] `{ $shape }` nimmt keine Parameter.
       *[other] `{ $shape }` nimmt { $known }.
    }
shape-out-of-range = `{ $parameter }` der Form `{ $shape }` ist { NUMBER($value, digits: 17) }, nicht zwischen { NUMBER($low, digits: 17) } und { NUMBER($high, digits: 17) }
    .hint = Nehmen Sie einen Wert von { NUMBER($low, digits: 17) } bis { NUMBER($high, digits: 17) }.
shape-not-an-integer = `{ $parameter }` der Form `{ $shape }` ist { NUMBER($value, digits: 17) }, keine ganze Zahl
    .hint = Nehmen Sie { $nearest }.
shape-incompatible = die Form `{ $shape }` lässt sich nicht machen: { $reason }
    .hint = Ändern Sie einen der genannten Werte.
conflict-thick-tube = minor = { NUMBER($minor, digits: 17) } ist nicht kleiner als major = { NUMBER($major, digits: 17) }
conflict-shear = shear × rows = { NUMBER($turn, digits: 17) } ist keine ganze Zahl
conflict-odd = { $parameter } = { $value } ist ungerade
conflict-too-coarse = level { $level } ist zu grob für Löcher vom Radius { NUMBER($radius, digits: 17) }
conflict-holes-overlap = { $count } Löcher vom Radius { NUMBER($radius, digits: 17) } haben keinen Platz; bei diesem level muss er unter { $most } sein
conflict-tubes-meet = { $count } Rohre vom Radius { NUMBER($radius, digits: 17) } stoßen zusammen; er muss unter { $most } sein
conflict-patches-too-long = Flicken vom Radius { NUMBER($radius, digits: 17) } passen nicht auf die Länge
conflict-no-room = bei resolution { $resolution } ist kein Platz für { $count } Löcher
conflict-subdivision = { $reason }

## Lineare Gleichungssysteme

linear-zero-pivot = die Matrix ist singulär: Das Pivotelement von Zeile { $row } ist null
    .hint = Nehmen Sie einen kleineren Schritt.
linear-non-finite-entry = die Matrix hat in Spalte { $column } einen nicht endlichen Eintrag
    .hint = Vielleicht ist ein Dreieck zusammengefallen: Nehmen Sie einen kleineren Schritt oder reparieren Sie das Netz.
linear-non-finite-right-hand-side = die rechte Seite ist bei Ecke { $row } nicht endlich
    .hint = Vielleicht ist ein Dreieck zusammengefallen: Nehmen Sie einen kleineren Schritt oder reparieren Sie das Netz.
linear-out-of-memory = die Zerlegung einer Matrix mit { $n } Zeilen passt nicht in den Speicher
    .hint = Nehmen Sie ein gröberes Netz.
linear-index-overflow = die Zerlegung einer Matrix mit { $n } Zeilen hat mehr Einträge, als sich zählen lassen
    .hint = Nehmen Sie ein gröberes Netz.
linear-interrupted = die Arbeit wurde abgebrochen
    .hint = Starten Sie sie noch einmal.

## Füllen

fill-no-loops = das Netz hat keine Randkurve
    .hint = Es gibt nichts zu füllen.
fill-loop-out-of-range = es gibt keine Randkurve { $index }; das Netz hat { $loops }, ab 0 gezählt
    .hint = Nehmen Sie alle Randkurven oder eine von denen, die es gibt.
fill-touching-loop = Randkurve { $index } berührt sich selbst: Die Ecken { VERTEX($a, bare: 1) } und { VERTEX($b) } liegen am selben Ort
    .hint = Eine Reparatur näht Ränder zusammen, die aufeinander liegen.
fill-straight-loop = die ganze Randkurve { $index } liegt auf einer Linie und hat kein Inneres
    .hint = Eine Reparatur schließt eine solche Lücke, wie sie eine Ecke mitten auf einer Kante lässt.
fill-no-small-loops = { $loops ->
    [one] die Randkurve ist
   *[other] die { $loops } Randkurven sind
} kein kleines Loch: Der äußere Rand eines Blatts und die Mündung einer Röhre bleiben offen, solange sie nicht gewählt werden
    .hint = Verlangen Sie alle Randkurven, oder einige mit ihren Nummern: `umbilic info` nennt sie, und „Löcher füllen“ zeigt sie.
fill-no-room = an Randkurve { $index } ist kein Platz für einen Flicken: Er fiele auf Facetten, die es schon gibt
    .hint = Lassen Sie die Randkurve offen, oder löschen Sie die Facetten um sie.
fill-not-orientable = die Fläche hat keine einheitliche Orientierung
    .hint = Eine einseitige Fläche lässt sich nicht füllen.
fill-too-few-loops = { $loops ->
    [one] { $loops } Randkurve lässt
   *[other] { $loops } Randkurven lassen
} sich nicht verbinden
    .hint = Nennen Sie zwei oder mehr Randkurven, oder füllen Sie sie einzeln.
fill-hidden-loop = Randkurve { $index } liegt bei Ecke { VERTEX($vertex) } nicht auf der konvexen Hülle der zu verbindenden Randkurven
    .hint = Rücken Sie die Teile auseinander, oder lassen Sie diese Randkurve weg; runde Randkurven, die einander gegenüberliegen, lassen sich verbinden.
fill-loops-too-close = die Ecken { VERTEX($a, bare: 1) } und { VERTEX($b) } zweier Randkurven sind schon durch eine Kante verbunden
    .hint = Füllen Sie die Randkurven einzeln.
fill-cancelled = das Füllen wurde abgebrochen
    .hint = Beginnen Sie neu, wann Sie möchten.
fill-mesh = das gefüllte Netz ist keine Fläche: { $reason }
fill-linear = das lineare Gleichungssystem ließ sich nicht lösen: { $reason }
fill-notice-left-open = Offen gelassen: { $reason }.
fill-notice-large-hole = Das Loch an { COUNT($loops) ->
    [one] Randkurve { $loops }
   *[other] den Randkurven { $loops }
} ist größer als eine Halbkugel: Es glatt zu schließen kostet { NUMBER($hemispheres, digits: 2) }-mal so viel Krümmung, und seine Form ist geraten.
fill-notice-low-order = Der Flicken an { COUNT($loops) ->
    [one] Randkurve { $loops }
   *[other] den Randkurven { $loops }
} { $order ->
    [2] trifft die Fläche um ihn mit ihren Tangentialebenen, aber nicht mit ihrer Krümmung
    [1] trifft die Fläche um ihn mit einem Knick
   *[other] bleibt eine Membran
}: { $cause ->
    [near-boundary] Um ihn liegen weniger als drei Ringe der Fläche
    [size] Er hat { $vertices } neue Ecken
    [folds] Ein glatterer würde umklappen
    [side] Sein Rand ist eben, und Kanten der Form enden dort: Es fehlt eine Seite
   *[rough] Die Fläche um ihn ist zu rau, um fortgesetzt zu werden
}.
fill-notice-coarser = Die Kantenlängen der Randkurven verlangen etwa { $vertices } neue Ecken, mehr als die Grenze von { $most }: Die Kanten der Flicken sind { NUMBER($times, digits: 2) }-mal so lang.

## Regularisieren

regularise-only-creases = alle { $vertices } Ecken liegen auf Kanten der Form, die eine Regularisierung erhält
    .hint = Verfeinern Sie zuerst das Netz: Neue Ecken im Innern seiner Facetten können gleiten.
regularise-distance-bound = jeder Durchgang würde die Fläche um mehr als { $percent } % ihrer Größe verschieben
    .hint = Verfeinern Sie zuerst das Netz: Neue Ecken im Innern seiner Facetten können gleiten.
regularise-volume-bound = jeder Durchgang würde das Volumen um mehr als { $percent } % ändern
    .hint = Verfeinern Sie zuerst das Netz: Neue Ecken im Innern seiner Facetten können gleiten.
regularise-box-bound = jeder Durchgang würde den Hüllquader um mehr als { $percent } % ändern
    .hint = Verfeinern Sie zuerst das Netz: Neue Ecken im Innern seiner Facetten können gleiten.
regularise-angle-bound = jeder Durchgang würde den kleinsten Winkel verkleinern, und unter { $degrees }°
    .hint = Verfeinern Sie zuerst das Netz: Neue Ecken im Innern seiner Facetten können gleiten.
regularise-linear = das lineare Gleichungssystem ließ sich nicht lösen: { $reason }

## Neu vernetzen

remesh-not-triangular = zum Neuvernetzen braucht es Dreiecke
    .hint = Das Netz vorher in Dreiecken schreiben.
remesh-not-oriented = eine einseitige Fläche wird nicht neu vernetzt
    .hint = Stattdessen ihre zweiblättrige Überlagerung neu vernetzen.
remesh-all-held = nichts darf sich ändern: alle Ecken sind fest oder liegen auf dem Rand
    .hint = Einige Ecken freigeben oder das Netz erst unterteilen.
remesh-spoilt = die Fläche wäre eine andere geworden: Sie ist zu grob, zu dünn oder zu zerknittert, um neu vernetzt zu werden
    .hint = Verlangen Sie mehr Ecken, oder unterteilen oder glätten Sie sie zuerst: Was dünner ist, als seine Dreiecke lang sind, bleibt nicht erhalten.
