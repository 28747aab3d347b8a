# Was allein die Kommandozeile sagt: Optionen ihrer Befehle und Tabellen von Messungen.

## Randkurven, wie `umbilic info` sie nennt

loop-line = Randkurve { $number }: { $edges } Kanten, Länge { $length }, bei Ecke { $vertex }{ $small ->
    [true] {""}
   *[other] ; kein kleines Loch
}
loop-more = … und { $count } weitere: --json nennt alle

## Optionen anderer Befehle

energy-p-help = weitere Exponenten von ∫|H|^p dA, neben 0 bis 4
energy-boundary-help = bei offenen Netzen: welche Terme zählen und welche Ecken sich bewegen

regularise-mode-help = nonlinear erhält das Volumen besser
regularise-epsilon-help = 1e-3 ist getreu, 1e-1 kräftig
regularise-iterations-help = höchstens so viele Durchgänge
regularise-features-help = wie fest Merkmale bleiben; bei 0 gleiten auch Kanten

repair-weld-help = verschweißt Randecken innerhalb dieser Länge; auto ist 1e-6 der Größe, oder was einfache Genauigkeit rundet, und höchstens ein Hundertstel einer Kante
fill-loops-help = welche Randkurven, gezählt ab 0; small lässt äußere Ränder offen
fill-connect-help = verbindet diese Randkurven, ohne Auswahl alle, durch einen Flicken, statt jede zu schließen
fill-maxVertices-help = höchstens so viele neue Ecken; auto heißt 200000

flips-criterion-help = { option-criterion-help }
flips-guardFolds-help = { option-guardFolds-help }
flips-max-help = höchstens so viele Flips

remesh-kind-help = adaptive: kurze Kanten, wo sich die Fläche biegt; isotropic: lauter gleiche
remesh-target-help = mittlere Länge der Kanten, abseits von Rändern, die bleiben
remesh-creases-help = Kanten der Form, an denen sich Flächen unter mehr als 60° treffen, oder ebene Seiten unter mehr als 40°: keep hält sie, smooth nimmt sie für Rauschen
remesh-vertices-help = Zahl der Ecken; so viele wie vorher, wenn keines von beiden gegeben ist

bench-table-help = welche Tabelle
bench-maxVertices-help = lässt größere Netze weg
bench-steps-help = gemessene Schritte je Zeile, nach einem, der nicht zählt
bench-figures-help = von der Tabelle figures nur diese
bench-quick-help = von der Tabelle figures nur die, die wenige Sekunden dauern

## Tabellen von Messungen

measured-refused = { $kind }: { $message }

bench-circle = Ein Schritt des Kreiswinkelflusses auf einem Torus und ein Versuch eines Schrittes, in Millisekunden (Mediane)
bench-p-willmore = p-Willmore-Fluss, p = 2, auf einem Torus: ein Schritt mit erhaltenem Flächeninhalt und Volumen und
    nichtlinearer Regularisierung oder ein Durchgang der Regularisierung allein; Millisekunden (Mediane von Schritten)
    und die aus Tabelle 1 der Arbeit, gemessen auf einem anderen Rechner
bench-flips = Kantenflips bis zum Ende auf einem Torus verwackelter Punkte mit zufällig geteilten Zellen: Millisekunden,
    tausend Flips je Sekunde und Nanosekunden durch E log₂ E
bench-mmcv = Fluss kleinster Variation der mittleren Krümmung: Millisekunden des ersten und eines späteren Schrittes
    (Mediane), Schritte bis zur Ruhe sowie Aufstellen und Lösen des Systems in Tabelle 5.1 der Arbeit,
    gemessen auf einem anderen Rechner, mit dem Verhältnis ihres Schrittes zu unserem
bench-refinement = Flächeninhalt, W/2 und ∫H² nach Kotangens und nach Anpassung unter Verfeinerung, mit beobachteten Ordnungen;
    die Kreisenergie strebt nur längs der Krümmungslinien gegen ∫(H² − K) dA
bench-repair = Lose Dreiecke einer STL-Datei werden eine Fläche: Millisekunden zum Öffnen mit der Suche nach dem,
    was zu reparieren ist, und zum Reparieren
bench-robustness = Wie Flüsse enden, sich selbst überlassen: auf Formen mit Rauschen (h die mittlere Kantenlänge) oder auf den
    Netzen eines Ordners in 100 Schritten. Die Energie am Anfang und am Ende, der größte relative Anstieg
    des überwachten Funktionals in einem Schritt, der kleinste Winkel, den es gab
bench-vesicles = Vesikel in Ruhe, Flächeninhalt und Volumen fest: ∫H²/4π über dem reduzierten Volumen auf drei Zweigen,
    und wo sie sich kreuzen; erwartet ist der Wert von Rotationsformen
bench-figures = Die Abbildungen der vier Arbeiten: was erwartet wird und was hier gerade gemessen wurde
