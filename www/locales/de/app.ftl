# Die Anwendung: src/app.

## Was nicht geht

app-no-mesh = es gibt kein Netz
    .hint = Öffnen Sie zuerst ein Netz oder wählen Sie ein Beispiel.
app-not-fetched = ein Teil des Programms, der hierfür nötig ist, ließ sich nicht laden
    .hint = Nichts ist verloren: Prüfen Sie die Verbindung, und versuchen Sie es noch einmal.
app-cancelled = es wurde aufgegeben
    .hint = Es hat sich nichts geändert.
app-bad-options = die Optionen sind nicht lesbar: { $reason }
    .hint = Siehe die Liste der Optionen und ihrer Werte.
app-bad-option = { $name } kann nicht { $value } sein
    .hint = Erlaubt ist: { $allowed }.
app-bad-selection = Das Netz hat keine Ecke { $number }.
    .hint = Ecken haben die Nummern der Netzdatei, ab { $first }; eine, die keine Fläche benutzt, zählt nicht.
app-unknown-loops = `{ $word }` nennt keine Randkurven
    .hint = Nehmen Sie all, inner oder eine Liste von Zahlen.
app-unknown-field = es gibt kein Feld `{ $name }`
    .hint = Erlaubt ist: none, { $known }.
app-unknown-format = es gibt kein Format `{ $name }`
    .hint = Erlaubt ist: { $known }.
app-unknown-figure = es gibt keine Abbildung `{ $name }`
    .hint = Siehe die Liste der Abbildungen.
app-not-configured = es ist noch kein Fluss gewählt
    .hint = Wählen Sie einen, bevor Sie ein Feld abfragen.
app-held-positions = Kantenflips halten die Lagen fest, die eine Regularisierung verschieben würde
    .hint = Wählen Sie einen anderen Fluss, und regularisieren Sie dann.
app-fixed-start = Kantenflips und Flüsse nebeneinander gehen vom Netz selbst aus
    .hint = Beginnen Sie von hier, oder ändern Sie den Fluss vom Anfang an.
app-bad-positions = { $coordinates } Koordinaten passen nicht zu { $vertices } Ecken
    .hint = Laden Sie das Netz neu.
app-bad-point = { $coordinates ->
    [one] { $coordinates } Koordinate ist
   *[other] { $coordinates } Koordinaten sind
} angegeben
    .hint = Ein Zentrum hat drei.
app-bad-quadrilateral = { $corners ->
    [one] { $corners } Ecke ist
   *[other] { $corners } Ecken sind
} angegeben
    .hint = Ein Viereck hat vier.
app-no-such-vertex = es gibt keine Ecken { $corners }
    .hint = Wählen Sie eine andere Kante.
app-no-such-branch = es gibt keinen Zweig { $branch }
    .hint = Zweige werden vergessen, die ältesten zuerst, wenn es viele sind.
app-nothing-to-undo = es gibt nichts rückgängig zu machen
    .hint = Ein Füllen oder Kantenflips lassen sich rückgängig machen, sobald sie geschehen sind.
app-no-recipe = wie diese Fläche entstand, ist nicht bekannt: Ihre Lagen wurden eingesetzt, nachdem der Löser verloren gegangen war
    .hint = Gehen Sie mit „Anfang“ zum Anfang zurück, oder laden Sie das Netz neu.
app-no-study = es hat keine Studie begonnen
    .hint = Geben Sie an, was untersucht werden soll.
app-no-bench = keine Tabelle von Messungen ist begonnen
    .hint = Sagen Sie, welche.
app-no-step = es gibt keinen Schritt zu messen: { $reason }
    .hint = Lassen Sie das Netz weg, oder wählen Sie andere Optionen.
app-too-many-faces = das feinere Netz hätte { $faces } Facetten
    .hint = Mehr als { $most } werden nicht gemacht.
app-too-many-vertices = das neue Netz hätte { $vertices } Ecken
    .hint = Mehr als { $most } werden nicht gemacht.
app-centre-too-far = das Zentrum ist weiter als das { $most }-Fache der Größe der Fläche entfernt
    .hint = Aus solcher Ferne scheint eine Inversion nichts zu tun: Wählen Sie ein näheres Zentrum.
app-centre-too-near = das Zentrum ist um { $percent } % der Größe der Fläche von ihr entfernt, nötig sind { $least } %
    .hint = Ein Punkt der Fläche im Zentrum ginge ins Unendliche: Rücken Sie das Zentrum von ihr weg.

## Wie ein Lauf endete

run-over = { $ended }: { $reason }
run-not-at-rest = Der Flicken ist nicht in Ruhe: { $reason }.
run-folds = In { $folding } von { $steps ->
    [one] { $steps } Schritt
   *[other] { $steps } Schritten
} klappten Facetten um.

## Was man von einem Netz wissen sollte

notice-polygons = Das Netz hat { $count ->
    [one] { $count } Facette
   *[other] { $count } Facetten
} mit mehr als drei Ecken: { $kept ->
    [p-willmore] Der p-Willmore-Fluss behält sie, andere Flüsse arbeiten auf einer triangulierten Kopie
   *[none] Flüsse arbeiten auf einer triangulierten Kopie
}; Dateien werden mit den ursprünglichen Facetten geschrieben, nach Kantenflips mit Dreiecken.
notice-flat-triangles = Das Netz hat { $count ->
    [one] { $count } Dreieck
   *[other] { $count } Dreiecke
} ohne Flächeninhalt (Ecken auf einer Geraden), zuerst Facette { FACE($face, bare: 1) } an den Ecken { VERTEX($vertices) }: Eine Reparatur nimmt { $count ->
    [one] es
   *[other] sie
} heraus und schließt, was das öffnet.
notice-short-edges = Das Netz hat { $count ->
    [one] { $count } Kante
   *[other] { $count } Kanten
}, kürzer als ein Millionstel des Mittels, zuerst zwischen den Ecken { VERTEX($a, bare: 1) } und { VERTEX($b) }: Verschmelzen Sie solche Ecken (nach Abstand) für einen besseren Fluss.
notice-flipped-volume = Das Volumen ging von { NUMBER($before, digits: 4) } auf { NUMBER($after, digits: 4) }: Flips halten die Ecken und nicht die Form und schneiden über deren Kanten hinweg.
notice-self-intersections = Die Fläche durchdringt sich selbst, in { $count ->
    [one] { $count } Dreieckspaar
   *[other] { $count } Dreieckspaaren
}: Die Flüsse laufen trotzdem weiter.
notice-filled = Gefüllt: { $count ->
    [one] { $count } Randkurve
   *[other] { $count } Randkurven
}, mit { $vertices ->
    [one] { $vertices } neuen Ecke
   *[other] { $vertices } neuen Ecken
}.

## Woran es liegt

symptom-rejected-steps = Es ist alles in Ordnung: In Schritt { $step } { $count ->
    [one] wurde ein längerer Versuch, der Ecke { VERTEX($vertex) } am weitesten bewegt hätte,
   *[other] wurden { $count } längere Versuche, deren letzter Ecke { VERTEX($vertex) } am weitesten bewegt hätte,
} abgelehnt und τ = { $tau } genommen, womit die Energie fällt.
symptom-refused-steps = Jeder versuchte Schritt wurde abgelehnt: { $cause ->
    [TooFar] Selbst der letzte und kürzeste würde Ecke { VERTEX($vertex) } um mehr als eine halbe Kante bewegen.
    [Turn] Selbst der letzte und kürzeste würde Facette { FACE($face) } um mehr als 60° drehen.
    [Fold] Selbst der letzte und kürzeste würde Facette { FACE($face) } umklappen.
    [Sliver] Selbst der letzte und kürzeste würde Facette { FACE($face) } zum Splitter machen.
    [Constraints] Mit einer kleinen Bewegung dieser Fläche lassen sich Flächeninhalt und Volumen nicht beide beibehalten; am weitesten würde sich Ecke { VERTEX($vertex) } bewegen.
    [Bound] Selbst der letzte und kürzeste hätte weniger Energie als jede glatte Fläche dieser Topologie und würde Ecke { VERTEX($vertex) } am weitesten bewegen.
    [Unfit] Selbst der letzte und kürzeste ließe um Ecke { VERTEX($vertex) } keine Fläche, die sich anpassen lässt.
   *[other] Keiner senkt die Energie, auch nicht der letzte und kürzeste, der Ecke { VERTEX($vertex) } am weitesten bewegen würde.
}
symptom-cocircular-kink = An { $count ->
    [one] { $count } Kante
   *[other] { $count } Kanten
} liegen die vier Punkte beider Dreiecke auf einem Kreis; dort hat die Energie eine Kegelspitze, und mit der Winkelglättung ε = { $epsilon } führt kein Schritt von ihr hinab.
symptom-rising-energy = Die Energie steigt, von { $least } auf { $energy }: { $halved ->
    [0] Dieses Schema prüft nicht, ob sie fällt, und Schritte mit τ = { $tau } sind dafür zu lang; Ecke { VERTEX($vertex) } bewegte sich im letzten um { $moved } Kantenlängen.
   *[other] Für Schritte über τ = { $tau } ist die Matrix des Schritts indefinit, sodass sich Fehler verstärken; Ecke { VERTEX($vertex) } bewegte sich im letzten Schritt um { $moved } Kantenlängen.
}
symptom-pinch = Die Fläche schnürt sich bei Ecke { VERTEX($vertex) } ab: Der Hals dort ist { $width } breit, { $edges ->
    [0] zu dünn für einen Ring von Kanten
    [1] zu dünn für einen Ring von Kanten
    [2] zu dünn für einen Ring von Kanten
   *[other] mit Platz für { $edges } Kanten ringsum
}, und dieser Fluss zieht einen Hals in endlicher Zeit ganz zusammen.
symptom-inflating = Die Fläche ist auf das { $times }-Fache ihres Inhalts angeschwollen, da ∫H² nicht von der Größe abhängt, und das hat ihr Netz verschlissen: Der kleinste Winkel von Facette { FACE($face) } ist { $angle }°.
symptom-growing = Für jeden Exponenten über 2 fällt ∫|H|^p, wenn die Fläche wächst: Mit p = { $p } ist ihr Inhalt das { $times }-Fache dessen am Anfang, und sie kommt nie zur Ruhe.
symptom-shrinking = Für jeden Exponenten unter 2 fällt ∫|H|^p, wenn die Fläche schrumpft: Mit p = { $p } ist ihr Inhalt 1/{ $times } dessen am Anfang, und sie verschwindet in endlicher Zeit.
symptom-untrusted = Das Netz ist zu grob oder zu zerknittert, als dass seine Messwerte viel bedeuten, am meisten bei Ecke { VERTEX($vertex) }. Größte Krümmung mal Kante { NUMBER($bend, digits: 2) }, kleinstes Produkt von Flächen- und Eckennormalen { NUMBER($alignment, digits: 2) }, ∫K/4π weicht um { NUMBER($topology, digits: 2) } ab, ∫H² der Anpassungen das { NUMBER($energy, digits: 2) }-Fache von dem des Netzes.
symptom-halved-step = Das Verfahren des Artikels geht in Schritten fester Größe: Schritt { $step } wurde { $count ->
    [one] einmal
   *[other] { $count }-mal
} halbiert, auf τ = { $tau }, da seine Matrix nicht positiv definit war. Es geht weiter; die Energie kann steigen.
symptom-degenerate-faces = Das Netz entartet: Der kleinste Winkel von Facette { FACE($face) } ist { $angle }°, und am Anfang lag kein Winkel unter { $before }°; Schritte können nicht länger sein, als eine solche Facette erlaubt.
symptom-folded-faces = { $count ->
    [one] Facette { FACE($face) } ist gegen ihre Nachbarn umgeklappt: Um sie herum bedeuten Normalen und Krümmungen nichts, und Schritte sind kurz oder gehen fehl.
   *[other] { $count } Facetten sind gegen ihre Nachbarn umgeklappt, als erste Facette { FACE($face) }: Um sie herum bedeuten Normalen und Krümmungen nichts, und Schritte sind kurz oder gehen fehl.
}
symptom-below-smooth-minimum = Die Energie ist { $energy }, und keine glatte Fläche dieser Topologie hat weniger als { $smooth }: Das Netz ist zu grob, um zu bemerken, was sich zwischen seinen Ecken krümmt, am meisten bei Ecke { VERTEX($vertex) }.
symptom-flat-faces = { $count ->
    [one] Facette { FACE($face) } hat
   *[other] { $count } Facetten, zuerst Facette { FACE($face) }, haben
} keinen Flächeninhalt: Dort lässt sich nichts messen, und kein Schritt führt weiter.
symptom-unresolved = Das Netz zeigt seine Fläche nicht: Die Krümmungen dieser Dreiecke haben zusammen weniger Energie als jede glatte Fläche dieser Topologie, wie die von Nadeln.
symptom-large-exponent = Mit p = { $p } überwiegen die schärfsten Stellen alle anderen, am meisten Ecke { VERTEX($vertex) }: Selbst der kürzeste versuchte Schritt ginge zu weit.
symptom-too-rough = Nach { $steps } Schritten sollen sich Ecken noch immer um bis zu { $update } Kantenlängen bewegen: Der Anfang ist zu rau für einen Fluss sechster Ordnung; der letzte Schritt bewegte Ecke { VERTEX($vertex) } am weitesten.
symptom-unfit = Um Ecke { VERTEX($vertex) } ist die Fläche so weit zusammengefallen, dass sich ihr keine quadratische Fläche anpassen lässt, und nach Krümmungen aus solchen Anpassungen richtet sich dieser Fluss.
symptom-step-limit = Es ist alles in Ordnung: Nach { $steps ->
    [one] { $steps } Schritt
   *[other] { $steps } Schritten
} fällt die Energie noch, um { $percent } % im letzten, der Ecke { VERTEX($vertex) } am weitesten bewegte.
symptom-not-at-rest = Nach { $steps ->
    [one] { $steps } Schritt
   *[other] { $steps } Schritten
} ist die Fläche nicht in Ruhe; der letzte bewegte Ecke { VERTEX($vertex) } am weitesten.

## Was hilft

remedy-more-steps = Weitere Schritte
remedy-refinement-study = Verfeinerungsstudie
remedy-flip-and-go-on = Kanten flippen und weitermachen
remedy-back = { $steps ->
    [one] Ein Schritt zurück
   *[other] { $steps } Schritte zurückgehen
}
remedy-regularise-and-go-on = Netz regularisieren und weitermachen
remedy-regularise-and-diffuse = Regularisieren und Oberflächendiffusion verwenden
remedy-repair-and-go-on = Fläche reparieren und weitermachen
remedy-regularise-each-step = Nach jedem Schritt regularisieren
remedy-subdivide-and-go-on = Netz unterteilen und weitermachen
remedy-set-tau = τ auf { $tau } setzen
remedy-automatic-step = τ automatisch wählen
remedy-recommended-scheme = Empfohlenes Schema verwenden
remedy-set-epsilon = ε auf { $epsilon } setzen
remedy-first-guess = Von einem glatten ersten Ansatz ausgehen
remedy-keep-volume = Volumen beibehalten
remedy-keep-area = Flächeninhalt beibehalten
remedy-keep-both = Flächeninhalt und Volumen beibehalten
remedy-keep-only-volume = Nur das Volumen beibehalten
remedy-smooth-first = Zuerst mit p = { $p } glätten
remedy-use-flow = Fluss „{ $flow }“ verwenden
