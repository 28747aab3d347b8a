# Was allein die Kommandozeile sagt: ihre Befehle und deren Optionen, was sie ablehnt, und Tabellen
# von Messungen.

## Befehle, und wo mehr steht

overview = umbilic <Befehl> [Optionen]

    Geometrische Flüsse nach Art des Willmore-Flusses auf Dreiecksnetzen.

    { $commands }
    MESH ist eine Datei, die auf
    { $formats }
    endet, oder - für die Standardeingabe.
    umbilic <Befehl> --help nennt die Optionen eines Befehls, --version die Version.
    Rückgabewerte: 0 getan, 2 falsch aufgerufen, 3 Eingabe abgelehnt, 4 die Fläche ließ sich nicht gut
    halten: ein Fehlschlag, eine Singularität oder ein Kollaps.
overview-formats = { $read }, auch in { $packed }

summary-info = was ein Netz ist und was daran auffällt
summary-repair = macht aus einer defekten Datei eine ganze Fläche und sagt, was sich geändert hat
summary-energy = alle Energien und Integrale
summary-flow = lässt einen Fluss auf einem Netz laufen
summary-flips = kippt Kanten, solange das den Inhalt oder die Willmore-Energie senkt
summary-regularise = verschiebt Ecken entlang einer geschlossenen Fläche zu einem konformen Netz, oder lehnt ab
summary-remesh = gibt einer Fläche andere Dreiecke, von einer Größe oder so klein, wie sie sich biegt
summary-fill = schließt Löcher oder verbindet Randkurven und glättet die Flicken
summary-replay = tut noch einmal, was ein Rezept sagt, und vergleicht
summary-shape = schreibt eine Beispielform; ihre Parameter sind Optionen
summary-bench = misst eine Tabelle der Dokumentation

## Optionen, die sagen, was geschrieben wird und wie ein Befehl vorgeht

flag-json-help = das Ergebnis als JSON auf der Standardausgabe
flag-help-help = dies
flag-out-help = { $command ->
    [shape] das Netz
   *[other] das Netz am Ende
}: { $formats }
flag-history-help = { $command ->
    [flips] jeder Flip: Kante, Abnahme, Inhalt, W
   *[other] die Messwerte jedes Schritts, als Tabelle
}
flag-report-help = der Bericht, den --json ausgibt
flag-selection-help = die Ecken, die ein Fluss halten oder bewegen soll, falls es sie gibt, mit ihren Nummern im Netz
flag-list-help = alle Formen und ihre Parameter
flag-until-converged-help = bis er zur Ruhe kommt, wie lange das auch dauert
flag-self-intersections-help = zählt, wo die Fläche sich selbst durchdringt, vorher und nachher
flag-meshes-help = von der Tabelle robustness: Netze, auf denen jeder Fluss versucht wird
fill-fair-help = ein Fluss, der die neuen Ecken danach bewegt

## Was abgelehnt wird, bevor der Löser gefragt ist

usage-no-command = Es fehlt ein Befehl.
    .hint = umbilic --help nennt die Befehle.
usage-command = Es gibt keinen Befehl `{ $name }`.
    .hint = { $near ->
        [none] umbilic --help nennt die Befehle.
       *[other] Meinten Sie `{ $near }`?
    }
usage-shape = Es gibt keine Form `{ $name }`.
    .hint = { $near ->
        [none] --list zeigt alle, die es gibt.
       *[other] Meinten Sie `{ $near }`?
    }
usage-fair = `--fair` kann nicht `{ $name }` sein
    .hint = { $near ->
        [none] Erlaubt ist eines von { $names }.
       *[other] Meinten Sie `{ $near }`? Erlaubt ist eines von { $names }.
    }
usage-operands = Verlangte Argumente: { $wanted }; gegeben: { $given }.
    .hint = --help zeigt, wie.
usage-syntax = { $reason }
usage-takes-value = `--{ $flag }`: Diese Option verlangt einen Wert, { $value }.
usage-no-shape = Nennen Sie zuerst die Form: umbilic shape NAME.
    .hint = --list zeigt alle, die es gibt.
usage-no-out = --out FILE fehlt.
usage-flips = Für Kantenflips gibt es einen eigenen Befehl: umbilic flips.
usage-smooth = --until-converged gilt für --goal relax: Geglättet wird in einer festen Zahl von Schritten.
usage-both = Geben Sie --until-converged oder --{ $flag } an, nicht beides.
usage-unfaired = --{ $flag } verlangt --fair FLOW.
usage-meshes = --meshes verlangt --table robustness.
usage-no-rows = Keine Zeile dieser Tabelle hat so wenige Ecken.
usage-no-folder = { $folder } ist kein Ordner, der sich lesen lässt.
usage-empty-folder = { $folder } enthält kein Netz.
    .hint = Netze enden auf { $formats }.
usage-format = { $file } sagt nicht, welches Format zu schreiben ist.
    .hint = Der Name muss auf { $formats } enden.
usage-unwritable = { $file } lässt sich nicht schreiben: { $cause }.
usage-recipe-shape = Das Rezept beginnt mit dem Beispiel { $shape }: { $given } nützt nichts.
usage-recipe-mesh = Das Rezept beginnt mit dem Netz { $name }, das fehlt.
    .hint = Geben Sie es nach dem Rezept an, oder legen Sie es daneben.
usage-not-built = Der Löser ist noch nicht gebaut.
    .hint = Führen Sie im Ordner des Projekts einmal `npm run build` aus.
file-unreadable = { $file } lässt sich nicht lesen: { $cause }.
file-fault = { $code ->
    [ENOENT] es gibt keine solche Datei und keinen solchen Ordner
    [EACCES] das ist nicht erlaubt
    [EISDIR] es ist ein Ordner
   *[other] { $reason }
}
selection-no-json = { $file } ist kein JSON: { $reason }.
selection-no-list = { $file } enthält keine Liste von Eckennummern.
    .hint = Schreiben Sie [1, 2] oder {"{"}"{ $key }": [1, 2]{"}"}, mit den Nummern der Netzdatei: OBJ zählt ab 1, andere ab 0.
failure-crashed = Der Löser ist abgestürzt: { $reason }.
    .hint = Das ist ein Fehler des Lösers; mit dem Netz und den Optionen lässt er sich wiederholen.

## Was bei einem Befehl herauskommt

repair-pending = Reparatur: { $message }
repair-way = `umbilic repair MESH --out FILE` schreibt eine solche Fläche.
repair-nothing = Es war nichts zu reparieren.
repair-gap = Ränder verlaufen nahe beieinander: Versuchen Sie --weld { $gap }
result-warning = Warnung: { $message }
shape-written = { $file }: { $vertices } Ecken, { $faces } Flächen
replay-long = Das Rezept läuft etwa { $steps } Schritte.
replay-result = { $same ->
    [true] Wiederholt nach { $steps } Schritten, { $compared }.
   *[other] Nicht wiederholt nach { $steps } Schritten: Dies weicht ab, verglichen { $compared }.
}
replay-compared = { $exact ->
    [true] auf das letzte Bit
   *[other] auf { $tolerance } (von Version { $version } gemacht, sodass die letzten Bits abweichen dürfen)
}

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
