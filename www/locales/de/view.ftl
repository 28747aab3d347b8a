# Die Beschriftung der Seite.

## Oben, Leiste, Fenster

run-them = Ausführen
leave-it = Lassen

## Die Statuszeile

status-ready = Bereit
status-running = Läuft
status-running-to = Läuft bis Schritt { $goal }
status-paused = Angehalten bei Schritt { $step }
clause-ready = Abspielen mit dem Knopf oder der Leertaste.
clause-step = Schritt { $step }
clause-film = Schritt { $step } der Hälfte, die rückwärts gezeigt wird, danach beginnt der Film
clause-step-of = Schritt { $step } von { $last }
computing = Es wird gerechnet …
stop-now = Jetzt abbrechen
progress = Fortschritt
stage-assemble = Aufstellen
stage-factor = Faktorisieren
stage-newton = Newton-Schritte
stage-project = Inhalt und Volumen halten
stage-regularise = Dreiecke ausgleichen
stage-fill = Füllen
stage-triangulate = Löcher triangulieren
stage-remesh = Neu vernetzen
stage-flips = Kanten tauschen
stage-finish = Fläche messen
stage-repair = Reparieren
stage-replay = Dem Rezept folgen
stage-sequence = Gespeicherte Schritte schreiben
mode-paint = Über die Fläche ziehen, um Teile beweglich zu machen oder festzuhalten.
mode-fill = Einen Rand anklicken, um ihn zu wählen.
mode-remesh = Wählen, wie klein die Dreiecke werden.
mode-subdivide = Wählen, wohin die neuen Ecken kommen.
mode-invert = Den Mittelpunkt der Spiegelung ziehen.
mode-pick = Eine Ecke anklicken.
mode-edge = Eine Kante anklicken.

## Das Pult

transport = Wiedergabe
play = Abspielen
pause = Anhalten
again = Noch einmal abspielen
step = Schritt
back = Zurück
reset = Zum Anfang
history = Verlauf
start = Anfang
curve-empty = Hier wird die Energie gezeichnet, während sie fällt
energy-was = { $symbol }, anfangs { $energy }
speed = Tempo { $times }×
speed-keys = Tempo ([ und ])
loop = Endlos
larger-plot = Größeres Schaubild
branches = Zweige
count-branches = { $count ->
    [one] { $count } Zweig
   *[other] { $count } Zweige
}
branch = Ab Schritt { $from }: { $count ->
    [one] { $count } Schritt
   *[other] { $count } Schritte
}, Energie { $energy }
symbol-smoothedCircle = Willmore-Energie W
symbol-willmore = ∫H²
symbol-curvatureVariation = ∫|∇H|²
symbol-area = Flächeninhalt
symbol-helfrich = Energie

## Die Fläche in Worten

surface-named = Fläche: { $name }
surface-at = Fläche: { $name }, Schritt { $step }, Energie { $energy }, Inhalt { $area }
surface-pane = Fläche { $name }: { $what }
pane-note = Schritt { $step } · { $symbol } { $energy }
pane-step = Schritt { $step }
pane-flips = { $flips ->
    [one] { $flips } Flip
   *[other] { $flips } Flips
}, Inhalt { $area }, W { $circle }

## Fläche

sample = Beispiel
yours = Eigene
open-mesh = Netz öffnen …
mesh-size = { $vertices } Ecken · { $faces } Seiten{ $loops ->
    [0] {""}
    [one] {" · "}{ $loops } Rand
   *[other] {" · "}{ $loops } Ränder
}
found = In diesem Netz gefunden
found-broken = Nicht heil
    .hint = Eine Reparatur würde dies tun; sie lässt sich zurücknehmen.
found-repaired = Repariert
repair = Reparieren
repair-and-open = Reparieren und öffnen
repair-would = Eine Reparatur würde dies tun:
repaired-all = { $count ->
    [0] Es gibt nichts zu reparieren.
    [one] Repariert: { $count } Änderung.
   *[other] Repariert: { $count } Änderungen.
}
found-holes = { $count ->
    [one] { $count } Rand
   *[other] { $count } Ränder
}
    .hint = { $count ->
        [one] Er lässt sich füllen.
       *[other] Jeder lässt sich füllen, oder zwei verbinden.
    }
found-closed = Geschlossen
found-two-sided = Kein Rand, mit Innen und Außen.
found-one-sided = Kein Rand, einseitig.
found-even = Die Facetten sind gleichmäßig
found-uneven = Manche Dreiecke sind Splitter
found-angle = Kleinster Winkel { $angle }°
fill-start = Füllen …
even-out = Dreiecke ausgleichen
crossings-hint = Die Flüsse laufen trotzdem.
change-it = Verändern
tool-paint = Anmalen
tool-fill = Löcher füllen
tool-remesh = Neu vernetzen
tool-subdivide = Unterteilen
tool-invert = Spiegeln
tool-pick = Ecke wählen
tool-edge = Kante wählen
start-from-here = Von hier beginnen
undo = Zurücknehmen: { $what }
edit-remesh = das Neuvernetzen
edit-subdivision = die Unterteilung
edit-repair = die Reparatur
edit-inversion = die Spiegelung
edit-flips = die Kantenflips

## Werkzeuge

apply = Anwenden
done = Fertig
paint-free = Bewegen
paint-hold = Halten
brush-size = Größe
grow = Mehr
shrink = Weniger
hold-boundary = Rand halten
clear-paint = Löschen
paint-count = { $free }/{ $all } frei
region-count = { $free } von { $all } Ecken bewegen sich.
loops-chosen = { $count } von { $all } gewählt
boundary-loop = { $edges } Kanten, Länge { NUMBER($length, digits: 3) }
fill-chosen = { $count ->
    [one] Diesen füllen
   *[other] Diese { $count } füllen
}
fill-small = { $count ->
    [one] Das kleine Loch füllen
   *[other] { $count } kleine Löcher füllen
}
fill-all = { $count ->
    [one] Füllen
   *[other] Alle { $count } füllen
}
bridge = Verbinden
most-vertices = Neue Ecken ≤
remesh-number = Ecken
remesh-edges = Kanten behalten
    .about = Wo sich Flächen unter mehr als 60° treffen, oder ebene Seiten unter mehr als 40°
remesh-adaptive = Nach Krümmung vernetzen
remesh-isotropic = Gleichmäßig vernetzen
subdivide-loop = Teilen und glätten (Loop)
subdivide-linear = Nur teilen
inversion-centre = Mittelpunkt der Spiegelung
inversion-numbers = W { $before } → { $after }, ∫H² { $bending } → { $bendingNow }
pick-hint = Ihre Zahlen stehen unter Messen.

## Fluss

flow-unsuitable = Nicht für diese Fläche.
automatic = automatisch
unit = { $kind ->
    [mean] mittlere Kanten
    [steps] Schritte
    [flips] Flips
   *[other] { $unit }
}
applies = Änderungen ab
applies-start = Anfang
applies-here = diesem Schritt
flip-all = Alle Flips auf einmal
advanced = Weiteres
advanced-what = Schrittweite, Verfahren, Grenzen
step-size-as = als { $other ->
    [tau] τ
   *[dt] dt
}
recommended = Empfohlene Einstellungen

## Farben und Zeichnung

legend = Legende
look = Aussehen
colour-by = Färben nach
colour-none = Nichts
colour-mean-curvature = Mittlere Krümmung H
colour-gauss-curvature = Gaußsche Krümmung K
colour-willmore = Willmore-Energie Wᵢ
colour-gradient = Größe des Gradienten
colour-displacement = Verschiebung
colour-distance = Abstand der Bilder
colours-from-to = Farben: { $what }, von { $low } bis { $high }
round = rund
range-held = Skala für den ganzen Lauf
fit-range = An diesen Schritt anpassen
wireframe = Drahtgitter
wireframe-dense = Näher heran sind die Kanten zu sehen.
boundary-lines = Rand
cut = Aufschneiden
double-curves = Kurven, an denen sie sich durchdringt
shading = Schattierung
shading-smooth = Glatt
shading-flat = Flach
high-contrast = Hoher Kontrast
theme = Farbschema
theme-auto = System
theme-light = Hell
theme-dark = Dunkel
language = Language / Sprache
fit-view = Ansicht einpassen

## Messen

readings = Messwerte
reading-energy = Energie
reading-step = Schritt
reading-time = Zeit
reading-dt = Schrittweite
reading-area = Flächeninhalt
reading-volume = Volumen
reading-genus = Geschlecht
reading-vertices = Ecken
reading-faces = Seiten
reading-crossings = Dreieckspaare, die sich durchdringen
reading-angle = Kleinster Winkel
reading-milliseconds = Millisekunden je Schritt
reading-tension = Spannung λ
reading-pressure = Druck μ
reading-jump = Sprung von H am Rand des Flickens
genus-none = nicht orientierbar
volume-none = keines umschlossen
volume-reduced = { $volume } (reduziert { NUMBER($reduced, digits: 4) })
what-w-says = W ist die Summe der Winkel zwischen Umkreisen und nur dann 0, wenn alle Ecken auf einer Kugel liegen. W/2 ist mit ∫(H² − K) dA vergleichbar.
over-the-surface = { $what } über die Fläche
histogram-table = Verteilung als Tabelle
histogram-from = Ab
histogram-share = Anteil
figure-expects = Hier erwartet:
figure-holds = ✓ Wie erwartet:
figure-differs = Anders als erwartet:
all-steps = Tabelle aller Schritte
look-at-vertex = Eine Ecke ansehen
equation = Die Gleichung, Zeichen für Zeichen
study = Verfeinerungsstudie
conjecture = Die Vermutung auf diesem Netz
lab = Zufällige Vierecke

## Das größere Schaubild

quantity = Größe
quantity-energy = Energie
quantity-monitored = Was nie steigt
quantity-area = Flächeninhalt
quantity-volume = Volumen
quantity-angle = Kleinster Winkel
quantity-dt = Schrittweite
against = Über
against-step = Schritt
against-time = Zeit
scale = Achse
scale-auto = Automatisch
scale-log = Logarithmisch
scale-linear = Linear
plot-label = { $what } über den Lauf

## Vergleich

compare-hint = Gleicher Anfang, gleiche Kamera, gleiche Farben. Was sich unterscheidet:
contrast-flow = Fluss
contrast-p = Exponent p
contrast-regularise = Netzpflege
contrast-scheme = Schema
contrast-then = Einst und jetzt
pane-flow = Fluss von { $name }
add-pane = { $name } dazunehmen
remove-pane = { $name } entfernen
lockstep = Im Takt nach
lockstep-progress = Fortschritt
lockstep-time = Zeit
lockstep-step = Schritt
axis-progress = Ende jedes Flusses
axis-time = Zeit
axis-step = Schritte
times-differ = Ihre Zeiten sind nicht vergleichbar: die Flüsse messen Zeit in verschiedenen Einheiten.
show-panes = Zeigen
show-panes-side = Nebeneinander
show-panes-place = Am selben Ort
in-place-hint = Am selben Ort, eins nach dem anderen:
pane-colours = Farben
distance-to = Abstand zu { $name }
close-comparison = Vergleich beenden
nothing-to-flip = Es gibt noch kein zweites Bild: unter Vergleich wählen, was sich unterscheidet.
pane-lost = Ein Bild daneben kann nicht weiter: { $reason }
    .hint = Unter Vergleich ändern oder entfernen; die anderen laufen weiter.

## Teilen

share-hint = Ein Link trägt die ganze Szene: Fläche, Fluss, Schritt, Kamera und Farben.
copy-link = Link kopieren
link-copied = Link kopiert.
not-copied = Der Browser lässt die Seite nicht kopieren. Hier ist es:
save-as = Sichern als
download = Herunterladen
film = Film
film-record = Film aufnehmen
film-stop = Beenden und sichern
film-unable = Dieser Browser kann keine Filme aufnehmen.
film-hint = Aufgenommen wird, was auf der Bühne gespielt wird.
film-failed = Der Browser hat die Aufnahme beendet.
    .hint = Was bis dahin aufgenommen wurde, ist gesichert.
save-all-steps = Alle Schritte als ZIP
each-step-as = Jeder Schritt als
every = Jeder wievielte
save-steps = Schritte sichern
sequence-size = { $meshes ->
    [one] { $meshes } Netz
   *[other] { $meshes } Netze
}, etwa { NUMBER($megabytes, digits: 3) } MB vor dem Packen; höchstens 1 GB.
embed = In einer anderen Seite
embed-as = Einbetten als
embed-iframe = Rahmen (iframe)
embed-element = Element mit Skript
embed-size = Größe
copy-code = Code kopieren
code-copied = Code kopiert.
lack-editsTooLong = Die Bearbeitungen sind zu groß für einen Link: das heruntergeladene Netz oder ein Rezept mitschicken.
lack-editsUnknown = Die Fläche wurde von Hand bearbeitet, was der Link nicht trägt: das heruntergeladene Netz mitschicken.
lack-file = Der Link enthält Ihr Netz nicht: die Datei mitschicken.
lack-fileByDigest = Der Link enthält Ihr Netz nicht: die Datei mitschicken. Sie wird an ihrer SHA-256 erkannt.
lack-regionTooLong = Der bemalte Bereich ist zu groß für einen Link und fehlt darin.
lack-pathTooLong = Was unterwegs geändert wurde, ist zu groß für einen Link: ein heruntergeladenes Rezept schicken.
save-as-ply = PLY
save-as-ply-ascii = PLY, Text
save-as-ply-big = PLY, big-endian
save-as-obj = OBJ
save-as-off = OFF
save-as-stl = STL
save-as-stl-ascii = STL, Text
save-as-glb = glTF (GLB)
save-as-csv = Verlauf, CSV
save-as-recipe = Rezept, JSON
save-as-png = Bild, PNG

## Bibliothek

search = Suchen
search-hint = Suchen, zum Beispiel „Knoten“ oder „Abb 6“
shelves = Regale
open-now = Jetzt offen
library-size = { $vertices } Ecken
library-none = Nichts heißt so und nichts davon steht darin. Leeren Sie das Suchfeld, um alles zu sehen.
library-count = { $count ->
    [one] { $count } Fläche oder Abbildung
   *[other] { $count } Flächen und Abbildungen
}
shelf-all = Alle
shelf-first = Zum Beginn
    .about = Vier, die zeigen, was ein Fluss tut
shelf-closed = Geschlossene Flächen
    .about = Nichts wird festgehalten
shelf-tubes = Röhren und Knoten
    .about = Weite Wege
shelf-boundary = Mit Rand
    .about = Was am Rand gilt, entscheidet den Rest
shelf-repair = Reparatur
    .about = Scans, Narben und Löcher
shelf-flips = Kantenflips
    .about = Keine Ecke bewegt sich
shelf-papers = Aus den Arbeiten
    .about = Jede Abbildung, was die Arbeit sagt und was hier herauskommt

## Hilfe

help-what = Umbilic lässt Dreiecksnetze so fließen, dass sie sich weniger biegen, nach den Gleichungen von vier Arbeiten. Gerechnet wird in diesem Browser.
help-how = Eine Fläche aus der Bibliothek wählen oder eine eigene öffnen, abspielen, und über die Kurve unten ziehen, um jeden Augenblick anzusehen. Fluss ändert die Gleichung, Messen zeigt ihre Zahlen, Vergleich stellt zwei nebeneinander.
help-private = Was Sie öffnen, verlässt dieses Gerät nicht. Nach dem ersten Besuch geht die Seite auch ohne Verbindung.
keys = Tasten
keys-on = Einzelne Tasten
keys-turn = drehen die Fläche, die den Fokus hat
keys-clicker = weiter und zurück beim Vorführen
surface-gestures = Auf der Fläche
gestures = Ziehen dreht, mit Umschalt oder zwei Fingern verschiebt es, Rad oder Spreizen vergrößert, Doppelklick passt ein.
purpose = Wozu dieses Netz?
purpose-smooth = Ein wenig glätten
purpose-relax = Ganz entspannen
purpose-fill = Nur Löcher füllen
guide = Die Anleitung:
guide-first-look = ein erster Blick
guide-lecture = für die Vorlesung
guide-mesh = ein eigenes Netz
welcome-again = Begrüßung noch einmal zeigen
version = Version { $version }.
commands = Befehle
commands-hint = Was möchten Sie tun?
key-space = Leertaste
key-home = Pos1
key-end = Ende
key-ctrl-z = Strg Z
key-ctrl-k = Strg K

## Befehle

command-play = Abspielen oder anhalten
command-step = Einen Schritt weiter
command-back = Einen Schritt zurück
command-reset = Zurück zum Anfang, ohne die Schritte
command-start = Zum Anfang
command-end = Zum neuesten Schritt
command-slower = Langsamer
command-faster = Schneller
command-loop = Endlos
command-plot = Größeres Schaubild
command-library = Bibliothek öffnen
command-open = Netz öffnen …
command-surface = Fläche
command-flow = Fluss
command-measure = Messen
command-compare = Vergleichen
command-share = Teilen
command-colour = Nächste Farben
command-wireframe = Drahtgitter
command-fit = Ansicht einpassen
command-flip-panes = Bilder tauschen
command-present = Vorführen
command-undo = Letzte Bearbeitung zurücknehmen
command-commands = Liste der Befehle
command-help = Hilfe
command-paint = Bewegliches anmalen
command-fill = Löcher füllen
command-remesh = Neu vernetzen
command-subdivide = Unterteilen
command-invert = An einer Kugel spiegeln
command-repair = Reparieren
command-regularise = Dreiecke ausgleichen
command-adopt = Von hier beginnen
command-download = Netz herunterladen
command-picture = Bild sichern
command-boundary-lines = Rand zeigen
command-contrast = Hoher Kontrast

## Was geschehen ist

flips-adopted = Der Fluss beginnt mit dem Netz der getauschten Kanten. Zurücknehmen bringt das vorige wieder.
regular-already = { $pinned ->
    [0] Die Dreiecke sind so gleichmäßig wie möglich.
   *[other] Die Dreiecke sind so gleichmäßig wie möglich, solange { $pinned } Ecken auf Knicken bleiben; ein feineres Netz hat mehr zu bewegen.
}
remeshed = { $vertices } Ecken, kleinster Winkel { $angle }° vorher und { $angleNow }° jetzt. Zurücknehmen macht es rückgängig.
subdivided = In { $count } Dreiecke unterteilt. Zurücknehmen macht es rückgängig.
inverted = Die Fläche ist gespiegelt, und W hat sich um { NUMBER($change, digits: 2) } geändert. Zurücknehmen bringt die vorige wieder.
offer-fixed = Festen Rand verwenden
offer-free = Freigeben, was der Fluss freigibt
new-version = Eine neue Version ist bereit. Zum Verwenden die Seite neu laden.
no-picture = Es gibt kein Bild zu sichern.
    .hint = Das Netz sichern.
solver-crashed = Der Löser ist abgestürzt ({ $reason }). Ein neuer macht bei Schritt { $step } weiter.
    .hint = Wenn der Speicher knapp war: andere Tabs schließen oder ein Netz mit weniger Seiten nehmen.
solver-ended = Die Rechnung wurde beendet. Die Fläche ist wie nach Schritt { $step }.
    .hint = Abspielen geht von dort weiter.

## Links und Rezepte

link-is-long = Dieser Link rechnet etwa { $steps } Schritte.
link-wants-file = Dieser Link zeigt das Netz „{ $mesh }“, eine Datei auf dem Rechner dessen, der ihn gemacht hat.
    .hint = Die Datei hier öffnen; die Szene folgt dann.
link-other-file = „{ $name }“ ist nicht die Datei des Links, der „{ $mesh }“ zeigt; geöffnet ist sie trotzdem.
link-checked = { $outcome ->
    [same] Die Szene ist, wie sie geschickt wurde: Energie { NUMBER($energy, digits: 6) }.
    [near] Die Szene ist auf sechs Stellen, wie sie geschickt wurde: Energie { NUMBER($energy, digits: 6) }.
    [endsEarly] Der Link zeigt Schritt { $wanted }; hier endet der Fluss bei Schritt { $step }.
   *[off] Die Szene ist nicht, wie sie geschickt wurde: die Energie ist { NUMBER($energy, digits: 6) } bei Schritt { $step }, wo der Link { NUMBER($sent, digits: 6) } sagt.
}
link-differs = { $why ->
    [file] Das Netz ist nicht die Datei des Links.
    [version] Der Link ist von Version { $theirs } des Lösers; diese ist { $ours }.
    [unknown] Vielleicht ist es nicht die Datei, mit der der Link gemacht wurde.
   *[same] Dieselbe Version sollte dieselben Zahlen geben; bitte mit dem Link melden.
}
recipe-is-long = Dieses Rezept rechnet etwa { $steps } Schritte.
recipe-wants-mesh = Dieses Rezept ist für das Netz „{ $name }“. Diese Datei jetzt öffnen; das Rezept folgt.
recipe-other-mesh = Das ist nicht das Netz „{ $name }“ des Rezepts: sein Inhalt ist ein anderer.
recipe-compared = { $same ->
    [true] Das Rezept gibt die versprochene Energie, bis aufs letzte Bit.
   *[false] Das Rezept verspricht die Energie { NUMBER($expected, digits: 9) }; hier ist sie { NUMBER($got, digits: 9) }.
}

## Was eine einbettende Seite erfährt

embed-bad-value = „{ $word }“ kann nicht „{ $text }“ sein.
    .hint = Ein kopierter Link zeigt, wie seine Wörter geschrieben werden.
embed-bad-step = Ein Schritt ist eine ganze Zahl ab 0, nicht „{ $step }“.
embed-no-format = Es gibt kein Format „{ $format }“.
embed-no-request = Es gibt keine Anfrage „{ $type }“.
embed-known = Bekannt sind { $known }.
embed-bad-mesh = Ein Netz wird als `name`, mit Endung, und `bytes`, ein ArrayBuffer, geschickt.

## Eine Ecke

vertex-number = Nummer
vertex-leave = Keine
vertex-missing = Es gibt keine Ecke { VERTEX($vertex) }.
vertex-numbers = Ecke { VERTEX($vertex) }
vertex-position = Ort
vertex-valence = Grad
vertex-outside = zählt nicht zur Energie
vertex-defect = Kᵢ, Winkeldefekt
vertex-mean = H, punktweise
vertex-gauss = K, punktweise
vertex-principal = κ₁, κ₂ durch Anpassung
vertex-area = Inhalt, ein Drittel
vertex-radii = Umkreisradien
vertex-edges = Ihre Kanten
vertex-to = Zu
vertex-length = Länge
vertex-none = keiner
vertex-go = Zu Ecke { VERTEX($neighbour) }
vertex-boundary = { $counts ->
    [true] Eine Randecke: an ihren Randkanten steht β₂, gegen die Gerade durch eine Ecke im Unendlichen.
   *[false] Eine Randecke: ihre { $count } Randkanten haben nur einen Kreis und kein β, und Wᵢ zählt unter dieser Randbedingung nicht zur Energie.
}
circles = Umkreise
circles-drawn = { $some ->
    [true] { $drawn } Kreise von { $total } Dreiecken, von mehr nur ein Teil.
   *[false] { $drawn } Kreise von { $total } Dreiecken.
} { $leftOut ->
    [0] {""}
   *[other] { $leftOut }, größer als die Fläche, fehlen.
}
directions = Krümmungslinien
directions-drawn = { $drawn } von { $total } Ecken, { $leftOut } an Nabelpunkten haben keine. { $share } % der Kanten liegen höchstens 5° neben einer Krümmungslinie; zufällig wären es 11 %.
