# Was gelesen wird, bevor es einen Solver gibt; auf der Seite kommt es mit dem Skript.

## Die Seite ohne Fläche

library = Bibliothek
present = Vorführen
help = Hilfe
close = Schließen
full-height = Ganze Höhe
full-page = Ganze Seite
    .title = Diese Szene auf der ganzen Seite öffnen
dismiss = Verwerfen
panels = Bereiche
tab-surface = Fläche
tab-flow = Fluss
tab-measure = Messen
tab-compare = Vergleich
tab-share = Teilen
messages = Meldungen

## Die Statuszeile

status-starting = Der Löser startet …
status-loading = { $name } wird geladen …
status-restoring = Die Fläche wird wiederhergestellt …
status-failed = Der Löser läuft nicht
status-stuck = Der Fluss kann nicht beginnen
status-empty = Zum Beginn ein Netz öffnen
clause-private = Was Sie hier öffnen, verlässt dieses Gerät nicht.
notes = { $count ->
    [one] { $count } Hinweis
   *[other] { $count } Hinweise
}
why = Warum?

## Ein Solver, der nicht da ist

solver-silent = Der Löser gibt seit einiger Zeit kein Lebenszeichen; vielleicht arbeitet er an etwas Großem.
solver-gone = Was zu sehen ist, lässt sich noch sichern.
restart-solver = Löser neu starten
solver-not-started = Der Löser ließ sich nicht starten.
    .hint = Die Seite neu laden; ihre Adresse behält die Szene.
too-many-requests = Mehr als { $most } Anfragen warten auf eine Antwort.
    .hint = Warten Sie die Antworten ab, bevor Sie weitere stellen.
worker-forbidden = Der Löser darf hier nicht starten: { $reason }
    .hint = Wenn diese Seite in einem Rahmen mit `sandbox` steht, braucht der `allow-same-origin` neben `allow-scripts`.
worker-not-loaded = er konnte nicht geladen werden

## Die Fläche

surface-none = Fläche: noch keine
drawn-with = Gezeichnet mit { $name }: { $reason }.

## Karten

welcome = Zusehen, wie eine Fläche ihre Form findet
welcome-text = Dieser eingedellte Ball bewegt sich so, dass er sich möglichst wenig biegt. In wenigen Sekunden ist er rund, und jeder Schritt dahin ist zu sehen.
watch = Fließen lassen
    .name = Abspielen: Fließen lassen
sample-vesicle = Vesikel
    .small = zum Blutkörperchen
sample-coarse-torus = Grober Torus
    .small = zu Cliffords Torus
own-mesh = Eigenes Netz
    .small = bleibt hier
no-picture-here = Hier kein Bild
no-picture-hint = Alles andere geht auch ohne: der Fluss läuft, Zahlen und Kurve folgen ihm, und das Netz lässt sich sichern.

## Was zeichnet

viewer-context-taken = der Browser hat den WebGL-Kontext weggenommen
viewer-no-picture = kein Bild
viewer-not-loaded = der Betrachter konnte nicht geladen werden: { $reason }
    .hint = Die Verbindung prüfen und die Seite neu laden.
renderer-asked = die Adresse verlangt es
renderer-no-webgpu = dieser Browser hat kein WebGPU, oder die Seite kommt nicht gesichert
renderer-offered = dieser Browser bietet es an
renderer-no-adapter = WebGPU bietet keine Grafikkarte an
renderer-no-webgl = dieser Browser hat kein WebGL2
renderer-neither = { $reason }; WebGL2 gibt es auch nicht
    .hint = Einen aktuellen Chrome, Edge, Firefox oder Safari nehmen, über https oder von localhost, und in seinen Einstellungen die Hardwarebeschleunigung einschalten.
