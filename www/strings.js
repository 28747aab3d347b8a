// @ts-check
// The page's own labels: English, as they stand in the sources, and their German. `{name}` is a
// value. `tests/web/language.test.js` says what is missing and what is left over. What the solver
// says stands in `locales`, in the same words:
//
// Words: mesh Netz, vertex Ecke, edge Kante, face Facette, surface Fläche, boundary loop
// Randkurve, flow Fluss, clamped eingespannt, sample Beispiel, readings Messwerte, pane
// Teilfenster, recipe Rezept, history Verlauf, branch Zweig, circle angle Kreiswinkel,
// circumcircle Umkreis, umbilic Nabelpunkt, fit Anpassung, first guess erster Ansatz, keep
// beibehalten, hold festhalten, refuse ablehnen.

/** @type {Readonly<Record<string, string>>} */
export const german = {
  // Header, panel, dialogs
  Umbilic: "Umbilic",
  "Figures of the papers": "Abbildungen der Arbeiten",
  Figures: "Abbildungen",
  "Present (F)": "Vortrag (F)",
  Present: "Vortrag",
  "Help (?)": "Hilfe (?)",
  Help: "Hilfe",
  Panel: "Bedienfeld",
  "Controls and readings": "Bedienung und Messwerte",
  Close: "Schließen",
  Messages: "Meldungen",
  Dismiss: "Ausblenden",
  "Drop a mesh to open it": "Zum Öffnen ein Netz hier ablegen",
  "Solver version {version}": "Löser, Version {version}",

  // Transport and status
  Transport: "Ablauf",
  "One step back ( , )": "Ein Schritt zurück ( , )",
  Back: "Zurück",
  Space: "Leertaste",
  Play: "Start",
  Pause: "Pause",
  "One step ( . )": "Ein Schritt ( . )",
  Step: "Schritt",
  "Back to the start ( R )": "Zurück zum Anfang ( R )",
  Reset: "Anfang",
  "End the long computation and go on from the last picture":
    "Die lange Rechnung beenden und beim letzten Bild weitermachen",
  "Stop now": "Jetzt abbrechen",
  "Starting the solver…": "Der Löser startet …",
  "The solver is not running": "Der Löser läuft nicht",
  "Loading {name}…": "{name} wird geladen …",
  "Restoring the surface…": "Die Fläche wird wiederhergestellt …",
  "The flow cannot start": "Der Fluss kann nicht beginnen",
  "Open a mesh to begin": "Zum Beginnen ein Netz öffnen",
  "Pausing after this step…": "Hält nach diesem Schritt an …",
  "Running to step {goal}": "Läuft bis Schritt {goal}",
  Running: "Läuft",
  Ready: "Bereit",
  "Paused at step {step}": "Angehalten bei Schritt {step}",
  "Step {step} of {goal}": "Schritt {step} von {goal}",
  Assembling: "Matrix aufstellen",
  Factorising: "Matrix zerlegen",
  "Newton iterations": "Newton-Iterationen",
  "Keeping area and volume": "Flächeninhalt und Volumen einhalten",
  "Regularising the mesh": "Netz regularisieren",
  Filling: "Füllen",
  "Triangulating the holes": "Löcher triangulieren",
  "Remeshing the patches": "Flicken neu vernetzen",
  "Flipping edges": "Kanten flippen",
  "Measuring the surface": "Fläche vermessen",
  "Following the recipe": "Rezept ausführen",
  "Writing the stored steps": "Gespeicherte Schritte schreiben",

  // History under the buttons
  History: "Verlauf",
  "Play history backwards": "Verlauf rückwärts abspielen",
  "Play history forwards": "Verlauf vorwärts abspielen",
  "Steps a second": "Schritte je Sekunde",
  "Step {step} of {last}": "Schritt {step} von {last}",
  Branches: "Zweige",
  "1 branch": "1 Zweig",
  "{count} branches": "{count} Zweige",
  "Branch from step {from} ({steps} steps, energy {energy})":
    "Zweig ab Schritt {from} ({steps} Schritte, Energie {energy})",
  "Change the flow from here on": "Den Fluss von hier an ändern",
  "A change goes on from step {step}.": "Eine Änderung geht von Schritt {step} aus weiter.",
  "A change goes on from step {step}; the steps after it are kept as a branch.":
    "Eine Änderung geht von Schritt {step} aus weiter; die Schritte danach bleiben als Zweig.",
  "The flow goes on from there; the steps that were to come are kept as a branch.":
    "Der Fluss geht von dort aus weiter; die Schritte, die danach kamen, bleiben als Zweig.",

  "The solver may not be started here: {reason}":
    "Der Löser darf hier nicht gestartet werden: {reason}",
  "If this page is in a frame with `sandbox`, that needs `allow-same-origin` beside `allow-scripts`.":
    "Steht diese Seite in einem Rahmen mit `sandbox`, so braucht der `allow-same-origin` neben `allow-scripts`.",

  // Why it stopped, and what helps
  "Why?": "Warum?",
  Show: "Zeigen",
  "Marks the place on the surface and turns it to the front":
    "Markiert die Stelle auf der Fläche und dreht sie nach vorn",
  "Fill holes": "Löcher füllen",
  "Use fixed boundary": "Festen Rand verwenden",
  "Free what the flow frees": "Freigeben, was der Fluss freigibt",
  "Use the circle-angle Willmore flow": "Willmore-Fluss der Kreiswinkel verwenden",
  "Use the recommended scheme": "Empfohlenes Schema verwenden",
  "the edge flips": "die Kantenflips",

  // Figure that is shown, and the gallery
  Figure: "Abbildung",
  "The paper reports": "Die Arbeit berichtet",
  "Expected here": "Hier zu erwarten",
  "Measured just now": "Soeben gemessen",

  // What is shown and how it flows
  Sample: "Beispiel",
  "Open mesh…": "Netz öffnen …",
  "Open mesh": "Netz öffnen",
  "OBJ, OFF, PLY, STL<span>, or drop it</span>": "OBJ, OFF, PLY, STL<span>, oder ablegen</span>",
  "A recipe, saved here before, is opened in the same way":
    "Ein hier gesichertes Rezept wird ebenso geöffnet",
  Flow: "Fluss",
  Boundary: "Rand",
  "Colour by": "Färben nach",
  "Edge flips": "Kantenflips",
  Nothing: "Nichts",
  "Mean curvature H": "Mittlere Krümmung H",
  "Gaussian curvature K": "Gaußsche Krümmung K",
  "Willmore energy Wᵢ": "Willmore-Energie Wᵢ",
  "Gradient size": "Betrag des Gradienten",
  Displacement: "Verschiebung",
  "Colours: {name} from {from} to {to}": "Farben: {name} von {from} bis {to}",
  "A change takes the surface back to the start.":
    "Eine Änderung bringt die Fläche zurück zum Anfang.",

  // p-Willmore flow
  "0: mean-curvature flow; 2: Willmore flow; above 2 free surfaces grow.":
    "0: Fluss nach der mittleren Krümmung; 2: Willmore-Fluss; über 2 wachsen freie Flächen.",
  Keep: "Beibehalten",
  Area: "Flächeninhalt",
  Volume: "Volumen",
  "Lead the reduced volume to": "Reduziertes Volumen führen auf",
  "In mean edge lengths: lets a symmetric vesicle leave a shape that is unstable.":
    "In mittleren Kantenlängen: So verlässt ein symmetrisches Vesikel eine Form, die instabil ist.",
  "Reduced volume": "Reduziertes Volumen",
  "Regularise the mesh now": "Netz jetzt regularisieren",
  "The mesh is as regular as it gets.": "Regelmäßiger wird das Netz nicht.",
  "The mesh is as regular as it gets while its vertices on creases stay, {pinned} of them; a finer mesh has more to move.":
    "Regelmäßiger wird das Netz nicht, solange seine Ecken auf Kanten der Form bleiben, {pinned} davon; ein feineres Netz hat mehr, das sich bewegen kann.",
  "Lagrange multipliers: {values}": "Lagrange-Multiplikatoren: {values}",
  "tension {value}": "Spannung {value}",
  "pressure {value}": "Druck {value}",

  // Flows by mean curvature and its derivatives
  "Flow by mean curvature or its derivatives":
    "Fluss nach der mittleren Krümmung oder ihren Ableitungen",
  "Smooth first guess where the start is rough": "Glatter erster Ansatz, wo der Anfang rau ist",
  "All four flows side by side": "Alle vier Flüsse nebeneinander",
  "Flows side by side": "Flüsse nebeneinander",
  "Jump of H": "Sprung von H",
  Status: "Stand",
  moving: "in Bewegung",
  converged: "konvergiert",
  singular: "singulär",
  collapsed: "kollabiert",
  "not regularised": "nicht regularisiert",
  stalled: "stecken geblieben",
  "at its limit": "an der Schrittgrenze",
  failed: "gescheitert",
  "Jump of H where the patch ends: {jump} of H outside, root mean square over {vertices} vertices.":
    "Sprung von H am Ende des Flickens: das {jump}-Fache von H außerhalb, quadratisches Mittel über {vertices} Ecken.",
  "No jump of H to measure: no patch ends next to what is held, or it is too small.":
    "Kein Sprung von H zu messen: Kein Flicken endet neben Festgehaltenem, oder er ist zu klein.",
  "{flow}: step {step}, jump of H {jump}": "{flow}: Schritt {step}, Sprung von H {jump}",
  "{flow}: step {step}": "{flow}: Schritt {step}",

  // Edge flips
  Localised: "Lokalisiert",
  "The flip that lowers this most comes first. A change takes the mesh back to the start.":
    "Zuerst kommt der Flip, der dies am stärksten senkt. Eine Änderung bringt das Netz zurück zum Anfang.",
  "A step is": "Ein Schritt ist",
  "1 flip": "1 Flip",
  "10 flips": "10 Flips",
  "100 flips": "100 Flips",
  "1000 flips": "1000 Flips",
  "All flips": "Alle Flips",
  "Beside it": "Daneben",
  "The start": "Der Anfang",
  Start: "Anfang",
  "All three criteria": "Alle drei Kriterien",
  Subdivide: "Unterteilen",
  Not: "Nicht",
  "Once, by Loop’s scheme": "Einmal, nach Loop",
  Twice: "Zweimal",
  "Flip to the end": "Bis zum Ende flippen",
  Curves: "Kurven",
  "Plot of area against the number of flips; where each criterion stands is in the table below":
    "Flächeninhalt über der Zahl der Flips; den Stand jedes Kriteriums zeigt die Tabelle darunter",
  "Willmore energy W": "Willmore-Energie W",
  "Plot of Willmore energy against the number of flips; where each criterion stands is in the table below":
    "Willmore-Energie über der Zahl der Flips; den Stand jedes Kriteriums zeigt die Tabelle darunter",
  "Where each criterion stands": "Stand jedes Kriteriums",
  "Area and Willmore energy by the number of flips":
    "Flächeninhalt und Willmore-Energie nach der Zahl der Flips",
  "Area by {criterion}": "Inhalt nach {criterion}",
  "W by {criterion}": "W nach {criterion}",
  By: "Nach",
  Flips: "Flips",
  Refused: "Abgelehnt",
  "{label}: area {area}, W {circle}": "{label}: Inhalt {area}, W {circle}",
  "{label}: {flips}, area {area}, W {circle}": "{label}: {flips}, Inhalt {area}, W {circle}",
  "The flow starts from the mesh with its edges flipped; Undo brings the one before back.":
    "Der Fluss beginnt beim Netz mit geflippten Kanten; „Rückgängig“ bringt das vorige zurück.",

  // The conjecture about edge flips
  "The conjecture: area against localised energy":
    "Die Vermutung: Flächeninhalt gegen lokalisierte Energie",
  "Brink and Alboul conjectured that a flip lowers the area if and only if it lowers the localised Willmore energy. <strong>That is refuted.</strong> Where four points are nearly coplanar both signs are those of the Delaunay test, as far as numbers show; with the angle between the faces, counterexamples come. The sample “Counterexample” is one to check by hand: f<sub>a</sub> = 15/2 − 2√2 − √89/2.":
    "Brink und Alboul vermuteten, dass ein Flip genau dann den Flächeninhalt senkt, wenn er die lokalisierte Willmore-Energie senkt. <strong>Das ist widerlegt.</strong> Liegen vier Punkte beinahe in einer Ebene, so sind beide Vorzeichen die des Delaunay-Tests, soweit Zahlen das zeigen; mit dem Winkel zwischen den Facetten kommen Gegenbeispiele. Das Beispiel „Gegenbeispiel“ lässt sich von Hand nachrechnen: f<sub>a</sub> = 15/2 − 2√2 − √89/2.",
  "On this mesh it holds for all {total} edges.":
    "Auf diesem Netz gilt sie für alle {total} Kanten.",
  "On this mesh it holds for {percent} % of {total} edges and fails for {against}.":
    "Auf diesem Netz gilt sie für {percent} % von {total} Kanten und ist falsch für {against}.",
  "Reductions of {total} edges: {both} lower both, {neither} neither, {areaOnly} only the area, {localisedOnly} only the localised energy":
    "Gewinn bei {total} Kanten: {both} senken beides, {neither} keines, {areaOnly} nur den Flächeninhalt, {localisedOnly} nur die lokalisierte Energie",
  "Reductions of the edges": "Gewinn bei jeder Kante",
  "f<sub>a</sub> → lowers area": "f<sub>a</sub> → senkt den Inhalt",
  "f<sub>l</sub> → lowers localised energy": "f<sub>l</sub> → senkt die lokalisierte Energie",
  "Edges by what their flip lowers": "Kanten danach, was ihr Flip senkt",
  "Area not": "Inhalt nicht kleiner",
  "Area lower": "Inhalt kleiner",
  "Localised energy lower": "Lokalisierte Energie kleiner",
  "Localised energy not": "Lokalisierte Energie nicht kleiner",
  "Counterexamples, marked on the surface; click one":
    "Gegenbeispiele, auf der Fläche markiert; klicken Sie eines an",
  "Edge {i}–{j}: f_a {area}, f_l {localised}": "Kante {i}–{j}: f_a {area}, f_l {localised}",
  "f_a, area gained": "f_a, gewonnener Inhalt",
  "{gained} of {area}": "{gained} von {area}",
  "f_l, localised energy gained": "f_l, gewonnene lokalisierte Energie",
  "Angle between the faces": "Winkel zwischen den Facetten",
  "Smallest angle": "Kleinster Winkel",
  "Random quadrilaterals": "Zufällige Vierecke",
  "Half of them random tetrahedra, half flattened by a random factor; by the larger of the angles between the faces before and after the flip.":
    "Zur Hälfte zufällige Tetraeder, zur Hälfte um einen zufälligen Faktor abgeflachte; nach dem größeren der Winkel zwischen den Facetten vor und nach dem Flip.",
  "Draw quadrilaterals": "Vierecke ziehen",
  Stop: "Halt",
  "Counterexamples by angle": "Gegenbeispiele nach dem Winkel",
  Angle: "Winkel",
  Drawn: "Gezogen",
  Against: "Gegen",
  Share: "Teilen",
  Understand: "Verstehen",
  "Change the surface": "Die Fläche ändern",
  "Show and keep": "Zeigen und sichern",
  Fraction: "Anteil",
  "{total} random tetrahedra, {against} against: {share} ({areaOnly} lower only the area, {localisedOnly} only the localised energy).":
    "{total} zufällige Tetraeder, {against} dagegen: {share} ({areaOnly} senken nur den Flächeninhalt, {localisedOnly} nur die lokalisierte Energie).",

  // Holes and the region that moves
  "Holes: fill or connect": "Löcher füllen oder verbinden",
  "Choose boundary loops here or by a click on the surface. What is filled becomes a new start; only the new vertices move.":
    "Wählen Sie Randkurven hier oder durch einen Klick auf die Fläche. Gefülltes wird zum neuen Anfang; nur die neuen Ecken bewegen sich.",
  "Boundary loops": "Randkurven",
  "{count} boundary loops, the first {listed} of them listed.":
    "{count} Randkurven, die ersten {listed} davon in der Liste.",
  "{n}: {edges} edges, length {length}": "{n}: {edges} Kanten, Länge {length}",
  "Fill all": "Alle füllen",
  "Fill chosen": "Gewählte füllen",
  "One patch that joins all the chosen loops":
    "Ein Flicken, der alle gewählten Randkurven verbindet",
  "Connect chosen": "Gewählte verbinden",
  "New vertices": "Neue Ecken",
  "at most": "höchstens",
  "Region that moves": "Bereich, der sich bewegt",
  "Paint what the flow may change; the rest keeps its place.":
    "Malen Sie an, was der Fluss verändern darf; der Rest bleibt, wo er ist.",
  Paint: "Malen",
  "The brush": "Der Pinsel",
  frees: "gibt frei",
  holds: "hält fest",
  "Brush size": "Pinselgröße",
  "Grow by a ring": "Um einen Ring wachsen",
  Shrink: "Schrumpfen",
  "Hold the boundary": "Rand festhalten",
  "Shrink then holds a ring more at a time": "Schrumpfen hält dann jedes Mal einen Ring mehr fest",
  "As the flow has it": "Wie beim Fluss üblich",
  "{free} of {all} vertices move.": "{free} von {all} Ecken bewegen sich.",
  "Flows and flips then begin here": "Flüsse und Flips beginnen dann hier",
  "Keep as new start": "Als neuen Anfang behalten",
  Undo: "Rückgängig",
  "takes back {what}": "nimmt zurück: {what}",

  // Möbius inversion, subdivision
  "Möbius inversion": "Möbius-Inversion",
  "Centre of the inversion": "Zentrum der Inversion",
  "x ↦ c + r² (x − c)/|x − c|². Drag the centre c over the picture, or focus it and use the arrow keys, with Page up and Page down away from you and towards you. Circles stay circles, their angles stay, and so does W.":
    "x ↦ c + r² (x − c)/|x − c|². Ziehen Sie das Zentrum c über das Bild, oder geben Sie ihm den Fokus und benutzen Sie die Pfeiltasten, dazu Bild ↑ und Bild ↓ von Ihnen weg und zu Ihnen hin. Kreise bleiben Kreise, ihre Winkel bleiben, und auch W bleibt.",
  "Centre, from the middle of the surface in diagonals of its box":
    "Zentrum, von der Mitte der Fläche aus in Diagonalen ihres Hüllquaders",
  "at {x}, {y}, {z}": "bei {x}, {y}, {z}",
  "Before and after the inversion": "Vor und nach der Inversion",
  Before: "Vorher",
  After: "Nachher",
  Change: "Änderung",
  Cancel: "Abbrechen",
  "W of interior vertices": "W der inneren Ecken",
  "W closed at infinity": "W, im Unendlichen geschlossen",
  "∫H² dA": "∫H² dA",
  "W changes by {share} of the sum of all angles, rounding; no vertex’s by more than {most}.":
    "W ändert sich um das {share}-Fache der Summe aller Winkel, durch Rundung; an keiner Ecke um mehr als {most}.",
  "∫H² dA stays on smooth closed surfaces; on a mesh it changes with its triangles.":
    "∫H² dA bleibt auf glatten geschlossenen Flächen gleich; auf einem Netz ändert es sich mit dessen Dreiecken.",
  "With the boundary closed by a vertex at infinity W is not invariant: the inversion takes infinity to a point. ∫H² dA changes by what ∫K dA does.":
    "Schließt eine Ecke im Unendlichen den Rand, so ist W nicht invariant: Die Inversion bringt das Unendliche in einen Punkt. ∫H² dA ändert sich um so viel wie ∫K dA.",
  "A reflection follows, so that normals point where they did.":
    "Eine Spiegelung folgt, damit die Normalen zur selben Seite zeigen wie zuvor.",
  "The centre is inside: outside and inside change places, and normals still point out.":
    "Das Zentrum liegt innen: Außen und Innen vertauschen sich, und die Normalen zeigen weiterhin nach außen.",
  "The size of the surface is kept.": "Die Größe der Fläche bleibt.",
  "the inversion": "die Inversion",
  "The surface is inverted; W has changed by {change}. Undo brings the one before back.":
    "Die Fläche ist invertiert; W hat sich um {change} geändert. „Rückgängig“ bringt die vorige zurück.",
  "Each triangle becomes four": "Aus jedem Dreieck werden vier",
  "How to subdivide": "Art der Unterteilung",
  "same surface": "dieselbe Fläche",
  "smoother, by Loop": "glatter, nach Loop",
  "a subdivision": "eine Unterteilung",
  "Subdivided into {count} triangles; Undo takes it back.":
    "In {count} Dreiecke unterteilt; „Rückgängig“ nimmt es zurück.",

  // Comparison of flows
  "Compare flows": "Flüsse vergleichen",
  "Up to four panes from the same start, stepping together. Each does as A, the flow chosen above, except for what is set here.":
    "Bis zu vier Teilfenster mit demselben Anfang, die gemeinsam Schritte machen. Jedes tut dasselbe wie A, der oben gewählte Fluss, bis auf das, was hier eingestellt ist.",
  "Add a pane": "Teilfenster hinzufügen",
  "Ready-made comparison": "Vergleich aus einer Vorlage",
  "Ready-made…": "Vorlagen …",
  "ε = 0.1 against 0.01": "ε = 0.1 gegen 0.01",
  "Recommended scheme against the paper’s": "Empfohlenes Schema gegen das der Arbeit",
  "p-Willmore: p = 1, 2, 3, 4": "p-Willmore: p = 1, 2, 3, 4",
  "p-Willmore: regularised, and not": "p-Willmore: regularisiert und nicht",
  "Four flows by mean curvature": "Vier Flüsse nach der mittleren Krümmung",
  "Willmore flow: circle angles, p-Willmore": "Willmore-Fluss: Kreiswinkel, p-Willmore",
  "Pane {pane}": "Teilfenster {pane}",
  "Remove pane {pane}": "Teilfenster {pane} entfernen",
  "Flip A and B": "Zwischen A und B wechseln",
  "One in the place of the other ( B )": "Eines anstelle des anderen ( B )",
  "Flip panes A and B in place; <kbd>Esc</kbd> side by side":
    "Am selben Platz zwischen Teilfenster A und B wechseln; <kbd>Esc</kbd> nebeneinander",
  "Side by side": "Nebeneinander",
  "All panes side by side.": "Alle Teilfenster nebeneinander.",
  "In place: {caption}": "Jetzt zu sehen: {caption}",
  "There is no pane to flip to yet: add one under “Compare flows”.":
    "Noch gibt es kein Teilfenster zum Wechseln: Fügen Sie unter „Flüsse vergleichen“ eines hinzu.",
  "Close panes": "Teilfenster schließen",
  "In lockstep": "Im Gleichschritt",
  "By step": "Nach Schritten",
  "By time": "Nach der Zeit",
  "By step all step at once; by time the one that is behind goes next.":
    "Nach Schritten machen alle zugleich einen Schritt; nach der Zeit ist jeweils das an der Reihe, das zurückliegt.",
  "By time is for flows whose times have one unit; these have {units}.":
    "Nach der Zeit geht es nur bei Flüssen, deren Zeiten dieselbe Einheit haben; diese haben {units}.",
  "Times of these flows have different units: the panes now go by step.":
    "Die Zeiten dieser Flüsse haben verschiedene Einheiten: Die Teilfenster gehen jetzt nach Schritten.",
  "length{power}": "Länge{power}",
  Colours: "Farben",
  "As chosen above": "Wie oben gewählt",
  "Distance to {pane}": "Abstand zu {pane}",
  "All curves": "Alle Kurven",
  "Plot with a curve a pane; the same numbers are in the table below it":
    "Je Teilfenster eine Kurve; dieselben Zahlen stehen in der Tabelle darunter",
  Quantity: "Messgröße",
  "Each flow’s own energy": "Eigene Energie jedes Flusses",
  "∫H² dA, for all alike": "∫H² dA, für alle gleich",
  "Smallest angle, degrees": "Kleinster Winkel in Grad",
  "The Willmore energy ∫H² dA by cotangents, the same for every flow: 4π for a sphere.":
    "Die Willmore-Energie ∫H² dA mit Kotangensgewichten, für jeden Fluss dieselbe: 4π für eine Sphäre.",
  "These flows have different energies: compare their course, and values by ∫H² dA.":
    "Diese Flüsse haben verschiedene Energien: Vergleichen Sie deren Verlauf, Werte aber nach ∫H² dA.",
  Steps: "Schritte",
  "Plotted numbers of all panes": "Zahlen aller Kurven",
  "A column a pane": "Eine Spalte je Teilfenster",
  "{value} at {time}": "{value} bei {time}",
  "step {step}, energy {energy}, t = {time}": "Schritt {step}, Energie {energy}, t = {time}",
  "p-Willmore, p = {p}": "p-Willmore, p = {p}",
  "automatic time step": "automatischer Zeitschritt",
  "recommended scheme": "empfohlenes Schema",
  "the paper’s scheme": "Schema der Arbeit",
  "nothing kept": "nichts fest",
  "{kept} kept": "{kept} fest",
  regularised: "regularisiert",
  "regularised linearly": "linear regularisiert",
  "regularisation ε = {value}": "Regularisierung ε = {value}",
  "smooth first guess": "glatter erster Ansatz",
  "no first guess": "ohne ersten Ansatz",
  "sharpened at the end": "am Ende geschärft",
  "not sharpened": "nicht geschärft",
  "semi-implicit": "semi-implizit",
  "forward Euler": "explizites Euler-Verfahren",
  "backward Euler": "implizites Euler-Verfahren",
  "mass: {value}": "Masse: {value}",
  "loading…": "wird geladen …",
  "failed: {reason}": "gescheitert: {reason}",
  "Pane {pane}: {stage}": "Teilfenster {pane}: {stage}",
  "Pane {pane}: {reason}": "Teilfenster {pane}: {reason}",
  "Waiting for pane {pane}": "Warten auf Teilfenster {pane}",
  "Edge flips change the mesh itself: the panes beside it were closed.":
    "Kantenflips verändern das Netz selbst: Die Teilfenster daneben wurden geschlossen.",
  "No pane can step on; Reset takes all back to the start.":
    "Kein Teilfenster kann weitere Schritte machen; „Anfang“ bringt alle zum Anfang zurück.",
  "Its solver stopped: {reason}": "Sein Löser ist stehen geblieben: {reason}",
  "it was ended": "er wurde beendet",
  "The solver of pane {pane} stopped ({reason}); a new one stands at step {step}. The other panes go on.":
    "Der Löser von Teilfenster {pane} ist stehen geblieben ({reason}); ein neuer steht bei Schritt {step}. Die anderen Teilfenster machen weiter.",
  "Play or Step takes the pane along again; Remove closes it.":
    "„Start“ oder „Schritt“ nimmt das Teilfenster wieder mit; „Entfernen“ schließt es.",
  "The solver of pane {pane} could not be started again ({reason}).":
    "Der Löser von Teilfenster {pane} konnte nicht neu gestartet werden ({reason}).",
  "Reset tries once more; the other panes go on without it.":
    "„Anfang“ versucht es noch einmal; die anderen Teilfenster machen ohne es weiter.",

  // Looking closer
  "Look closer": "Genauer hinsehen",
  "Show self-intersections": "Selbstdurchdringungen zeigen",
  "The surface does not pass through itself.": "Die Fläche durchdringt sich nirgends selbst.",
  "Too many triangles are near each other to compare them all.":
    "Zu viele Dreiecke liegen beieinander, um sie alle zu vergleichen.",
  "Pick a vertex": "Ecke auswählen",
  "Vertex number": "Nummer der Ecke",
  number: "Nummer",
  None: "Keine",
  "Click on the surface, or type a number; with the button focused, arrow keys walk to the neighbour seen there.":
    "Klicken Sie auf die Fläche, oder geben Sie eine Nummer ein; hat die Schaltfläche den Fokus, führen die Pfeiltasten zum Nachbarn, der in ihrer Richtung zu sehen ist.",
  "There is no vertex {vertex}.": "Es gibt keine Ecke {vertex}.",
  "The vertex": "Die Ecke",
  Position: "Lage",
  Valence: "Valenz",
  Σβ: "Σβ",
  "Wᵢ = Σβ − 2π": "Wᵢ = Σβ − 2π",
  "not part of the energy": "nicht Teil der Energie",
  "Kᵢ, angle defect": "Kᵢ, Winkeldefekt",
  "H, pointwise": "H, punktweise",
  "K, pointwise": "K, punktweise",
  "κ₁, κ₂ by a fit": "κ₁, κ₂ durch Anpassung",
  "Area, a third": "Flächeninhalt, ein Drittel",
  Circumradii: "Umkreisradien",
  "A boundary vertex: at its boundary edges stands β₂, against the line through a vertex at infinity.":
    "Eine Randecke: An ihren Randkanten steht β₂, der Winkel gegen die Gerade durch eine Ecke im Unendlichen.",
  "A boundary vertex: its {count} boundary edges have one circle only and no β, and Wᵢ is no part of the energy under this boundary condition.":
    "Eine Randecke: Ihre {count} Randkanten haben nur einen Kreis und keinen Winkel β, und Wᵢ gehört bei dieser Randbedingung nicht zur Energie.",
  "Edges, and the angles β of the circumcircles that meet there":
    "Kanten und die Winkel β der Umkreise, die sich dort treffen",
  "To vertex": "Zu Ecke",
  "Go to vertex {neighbour}": "Weiter zu Ecke {neighbour}",
  Length: "Länge",
  none: "keiner",
  "Circumcircles of all triangles": "Umkreise aller Dreiecke",
  "{drawn} circles of {total} triangles.": "{drawn} Umkreise von {total} Dreiecken.",
  "{drawn} of {total} circles, evenly chosen: of more than 6000 triangles only a part.":
    "{drawn} von {total} Umkreisen, gleichmäßig ausgewählt: bei mehr als 6000 Dreiecken nur ein Teil.",
  "{leftOut} larger than the surface are left out.":
    "Größer als die Fläche und deshalb weggelassen: {leftOut}.",
  "Lines of curvature": "Krümmungslinien",
  "κ₁, the larger": "κ₁, die größere",
  "κ₂, the smaller": "κ₂, die kleinere",
  "{drawn} of {total} vertices.": "{drawn} von {total} Ecken.",
  "{drawn} of {total} vertices: of more than 20000 only a part.":
    "{drawn} von {total} Ecken: bei mehr als 20\u202f000 nur ein Teil.",
  "At umbilics, κ₁ − κ₂ below 5 % of √(κ₁² + κ₂²), there are no directions.":
    "In Nabelpunkten, κ₁ − κ₂ unter 5 % von √(κ₁² + κ₂²), gibt es keine Richtungen.",
  "{share} of the edges lie within 5° of a line of curvature; 11 % do by chance.":
    "{share} der Kanten weichen höchstens 5° von einer Krümmungslinie ab; zufällig wären es 11 %.",
  Histogram: "Histogramm",
  "Histogram of the colours": "Histogramm der Farben",
  "Choose what to colour by, and its values are counted here.":
    "Wählen Sie, wonach gefärbt wird; die Werte werden hier gezählt.",
  "{label}: dashed are the ends of the colours.": "{label}: gestrichelt die Enden der Farbskala.",
  "Histogram of {label}: {count} vertices from {least} to {most}":
    "Histogramm, {label}: {count} Ecken von {least} bis {most}",
  "The values that colour the surface": "Die Werte, nach denen die Fläche gefärbt ist",
  Least: "Kleinster Wert",
  Greatest: "Größter Wert",
  "Mean over vertices": "Mittel über die Ecken",
  "Colours, symmetric about 0": "Farben, symmetrisch um 0",
  "Colours, 2nd to 98th percentile": "Farben, 2. bis 98. Perzentil",
  "Bars as numbers": "Balken als Zahlen",
  "Vertices by value": "Ecken nach Wert",
  From: "Von",
  To: "Bis",

  // Energy and readings
  Energy: "Energie",
  "W = Σ W<sub>i</sub> <span>(as printed)</span>":
    "W = Σ W<sub>i</sub> <span>(wie in der Arbeit)</span>",
  "∫|H|^p dA": "∫|H|^p dA",
  "∫H² dA <span>(about what moves)</span>": "∫H² dA <span>(um das, was sich bewegt)</span>",
  "∫|∇H|² dA <span>(about what moves)</span>": "∫|∇H|² dA <span>(um das, was sich bewegt)</span>",
  "W/2 <span>(→ ∫(H²−K) dA on curvature-aligned meshes only)</span>":
    "W/2 <span>(→ ∫(H²−K) dA nur auf Netzen entlang der Krümmungslinien)</span>",
  "Area over L² <span>(L: size of the patch)</span>":
    "Flächeninhalt durch L² <span>(L: Größe des Flickens)</span>",
  "The same <span>(it has no unit)</span>": "Dasselbe <span>(ohne Einheit)</span>",
  "∫|∇H|² dA · L² <span>(L: size of the patch)</span>":
    "∫|∇H|² dA · L² <span>(L: Größe des Flickens)</span>",
  "∫|H|<sup>p</sup> over the round sphere’s <span>(of the same area)</span>":
    "∫|H|<sup>p</sup> durch das der runden Sphäre <span>(gleichen Inhalts)</span>",
  "What these two numbers say": "Was diese beiden Zahlen sagen",
  "H is half the sum of the principal curvatures. The paper’s W<sup>p</sup> has twice that, Y = 2H: it is 2<sup>p</sup> times the first number. For p = 2 that is the Willmore energy, 4π for a round sphere and 2π² for the Clifford torus, whatever their size.":
    "H ist die halbe Summe der Hauptkrümmungen. Das W<sup>p</sup> der Arbeit nimmt das Doppelte, Y = 2H: Es ist das 2<sup>p</sup>-Fache der ersten Zahl. Für p = 2 ist diese die Willmore-Energie, 4π für eine runde Sphäre und 2π² für den Clifford-Torus, gleich welcher Größe.",
  "With spontaneous curvature, tension or pressure the first number is Canham and Helfrich’s, ∫(H − H₀)² dA + ¼(σA − PV). The second number is ∫|H|<sup>p</sup> compared with that of a round sphere of the same area, for which it is 1. The reduced volume compares the volume with that sphere’s.":
    "Mit spontaner Krümmung, Spannung oder Druck ist die erste Zahl die von Canham und Helfrich, ∫(H − H₀)² dA + ¼(σA − PV). Die zweite Zahl vergleicht ∫|H|<sup>p</sup> mit dem einer runden Sphäre gleichen Flächeninhalts, für die sie 1 ist. Das reduzierte Volumen vergleicht das Volumen mit dem dieser Sphäre.",
  "W adds, over every vertex, the angles between the circumcircles of neighbouring triangles, less 2π. It has no unit, is never negative, does not change under Möbius transformations, and is zero exactly when the vertices lie on a sphere as a convex, Delaunay mesh.":
    "W addiert für jede Ecke die Winkel zwischen den Umkreisen benachbarter Dreiecke, abzüglich 2π. Es hat keine Einheit, ist nie negativ, ändert sich nicht unter Möbiustransformationen und ist genau dann null, wenn die Ecken als konvexes Delaunay-Netz auf einer Sphäre liegen.",
  "A step lowers not W but U<sub>ε</sub> = Σ 2√(β²+ε²) − 2πN (dashed in the plot), which never rises; W may, and does not by more than 5 % in a step.":
    "Ein Schritt senkt nicht W, sondern U<sub>ε</sub> = Σ 2√(β²+ε²) − 2πN (im Diagramm gestrichelt), das nie steigt; W darf steigen, aber in einem Schritt um höchstens 5 %.",
  "On meshes whose edges follow the lines of curvature, half of it tends to the Willmore energy ∫(H²−K) dA as the mesh is refined. On other meshes W/2 is larger, by a factor that depends on the triangles; compare it only with other states of the same mesh.":
    "Auf Netzen, deren Kanten den Krümmungslinien folgen, strebt die Hälfte davon bei Verfeinerung gegen die Willmore-Energie ∫(H²−K) dA. Auf anderen Netzen ist W/2 größer, um einen Faktor, der von den Dreiecken abhängt; vergleichbar ist es nur mit anderen Zuständen desselben Netzes.",
  "Plot of energy against step number; the same numbers are in the table below it":
    "Energie über der Schrittzahl; dieselben Zahlen stehen in der Tabelle darunter",
  Axis: "Achse",
  Automatic: "Automatisch",
  Logarithmic: "Logarithmisch",
  Linear: "Linear",
  "Plotted numbers": "Zahlen der Kurve",
  "U<sub>ε</sub>": "U<sub>ε</sub>",
  "Energy after each step": "Energie nach jedem Schritt",
  Time: "Zeit",
  "Step size": "Schrittweite",
  Readings: "Messwerte",
  Genus: "Geschlecht",
  Vertices: "Ecken",
  Faces: "Facetten",
  "Milliseconds per step": "Millisekunden je Schritt",
  "not orientable": "nicht orientierbar",
  "none enclosed": "keines umschlossen",
  "{volume} (reduced {reduced})": "{volume} (reduziert {reduced})",

  // Energy and equation in symbols
  "Energy and equation": "Energie und Gleichung",
  Equation: "Gleichung",
  "Symbols, as they are now": "Formelzeichen mit ihren jetzigen Werten",
  "step size": "Schrittweite",
  "without a unit": "ohne Einheit",
  "W in section 2, K in eq. (1), the step in section 4":
    "W in Abschnitt 2, K in Gl. (1), der Schritt in Abschnitt 4",
  "angle between the circumcircles of the triangles at edge ij":
    "Winkel zwischen den Umkreisen der Dreiecke an der Kante ij",
  "rounds off the cone of an angle at 0": "rundet den Kegel ab, den ein Winkel bei 0 hat",
  "mass of a vertex": "Masse einer Ecke",
  area: "Flächeninhalt",
  "K of eq. (1) as it is, with K x = ∇E": "K aus Gl. (1), unverändert, mit K x = ∇E",
  "K of eq. (1), with K x = ∇E, made semi-definite star by star":
    "K aus Gl. (1), mit K x = ∇E, Stern für Stern semidefinit gemacht",
  "mean edge length at the start": "mittlere Kantenlänge am Anfang",
  "which vertices": "welche Ecken",
  "interior vertices count": "die inneren Ecken zählen",
  "a vertex at infinity closes each loop": "eine Ecke im Unendlichen schließt jede Randkurve",
  "a vertex at infinity closes each loop; the boundary is held":
    "eine Ecke im Unendlichen schließt jede Randkurve; der Rand wird festgehalten",
  "the flow in theorem 3.2, eqs. (5)–(7); kept area and volume in problem 3.5; the paper’s step in problem 5.1. Its W^p, with Y = 2H, is 2^p E.":
    "der Fluss in Theorem 3.2, Gl. (5)–(7); fester Flächeninhalt und festes Volumen in Problem 3.5; der Schritt der Arbeit in Problem 5.1. Ihr W^p, mit Y = 2H, ist 2^p E.",
  exponent: "Exponent",
  "mean curvature, (κ₁ + κ₂)/2, positive on a sphere":
    "mittlere Krümmung, (κ₁ + κ₂)/2, positiv auf einer Sphäre",
  "spontaneous curvature": "spontane Krümmung",
  "tension, per ∫(2H)² dA": "Spannung, bezogen auf ∫(2H)² dA",
  "pressure, per ∫(2H)² dA": "Druck, bezogen auf ∫(2H)² dA",
  "tension that keeps the area, per E": "Spannung, die den Flächeninhalt erhält, bezogen auf E",
  "pressure that keeps or leads the volume, per E":
    "Druck, der das Volumen erhält oder führt, bezogen auf E",
  "cotangent Laplacian; C = p max(1, p − 1) |2H|^(p−2)/m on its diagonal":
    "Kotangens-Laplace-Operator; C diagonal, mit p max(1, p − 1) |2H|^(p−2)/m",
  "onto the vertex normals": "Projektion auf die Normalen der Ecken",
  "√(A/4π) at the start": "√(A/4π) am Anfang",
  "of the conformal penalty after each step (problem 5.3)":
    "Parameter des konformen Strafterms nach jedem Schritt (Problem 5.3)",
  "eq. (3.6), with H of the opposite sign": "Gl. (3.6), H mit umgekehrtem Vorzeichen",
  "F in (1.1), V in (3.1) and (3.8), with H and ◇ of the opposite sign":
    "F in (1.1), V in (3.1) und (3.8), H und ◇ mit umgekehrtem Vorzeichen",
  "the step in section 4": "der Schritt in Abschnitt 4",
  "mean curvature by quadratic fits, positive on a sphere":
    "mittlere Krümmung durch quadratische Anpassung, positiv auf einer Sphäre",
  "Gaussian curvature": "Gaußsche Krümmung",
  "gradient with the other curvature along each principal direction":
    "Gradient, längs jeder Hauptkrümmungsrichtung mit der anderen Hauptkrümmung",
  "outward normal": "äußere Normale",
  "linear in the next φ: one factor of each product is new":
    "linear im nächsten φ: In jedem Produkt ist ein Faktor neu",
  "share of the step: no vertex moves by more than half an edge":
    "Anteil des Schritts: Keine Ecke bewegt sich um mehr als eine halbe Kante",
  "without a unit; ℓ² is the area of a free patch":
    "ohne Einheit; ℓ² ist der Inhalt eines freien Flickens",
  "eq. (1)": "Gl. (1)",
  "eqs. (2) and (4), with its third term β of jkiv, as it must be":
    "Gl. (2) und (4), darin als dritter Term β zu jkiv, wie es sein muss",
  "eq. (5)": "Gl. (5)",
  "an edge, with apexes k and l": "eine Kante, ihr gegenüber die Ecken k und l",
  "angle between circumcircles, of four vertices in order":
    "Winkel zwischen Umkreisen, zu vier Ecken in dieser Reihenfolge",
  "area of a triangle": "Flächeninhalt eines Dreiecks",
  "the middles of (i, j) and (k, l)": "die Mittelpunkte von (i, j) und (k, l)",
  "the vertices beyond ik, il, jk and jl": "die Ecken jenseits von ik, il, jk und jl",
  "what the last flip gained": "was der letzte Flip gewann",
  "area now": "Flächeninhalt jetzt",
  "Willmore energy now": "Willmore-Energie jetzt",

  // Refinement study
  "Refinement study": "Verfeinerungsstudie",
  "The same surface at several resolutions, each with half the edge length of the one before: do its energies tend to those of the smooth surface? The flow goes on meanwhile.":
    "Dieselbe Fläche in mehreren Auflösungen, jede mit halb so langen Kanten wie die vorige: Streben ihre Energien gegen die der glatten Fläche? Der Fluss läuft derweil weiter.",
  Surface: "Fläche",
  "The sample, at its start": "Das Beispiel an seinem Anfang",
  "The surface as it is now": "Die Fläche, wie sie jetzt ist",
  "Run the study": "Studie ausführen",
  "Preparing the surface…": "Die Fläche wird vorbereitet …",
  "Measuring resolution {level}…": "Auflösung {level} wird vermessen …",
  "Done.": "Fertig.",
  "Cancelled.": "Abgebrochen.",
  "The study stopped unexpectedly ({reason}).":
    "Die Studie ist unerwartet stehen geblieben ({reason}).",
  "The smooth shape, sampled anew at each resolution; {most} vertices at most.":
    "Die glatte Form, in jeder Auflösung neu abgetastet; höchstens {most} Ecken.",
  "The polyhedron, its faces split into four each time; {most} vertices at most.":
    "Das Polyeder, jedes Mal jede Facette in vier geteilt; höchstens {most} Ecken.",
  "The limit surface of Loop’s scheme with this mesh as its control mesh, which lies a little inside: edges split at their midpoints would get no closer to a smooth surface. {most} vertices at most.":
    "Die Grenzfläche der Unterteilung nach Loop mit diesem Netz als Kontrollnetz; sie liegt ein wenig innerhalb: In ihren Mittelpunkten geteilte Kanten kämen einer glatten Fläche nicht näher. Höchstens {most} Ecken.",
  "Energies at each resolution, with their observed orders":
    "Energien in jeder Auflösung, mit den beobachteten Ordnungen",
  "order {order}": "Ordnung {order}",
  "Errors against edge length, both logarithmic; the same numbers are in the table above":
    "Fehler über der Kantenlänge, beide logarithmisch; dieselben Zahlen stehen in der Tabelle darüber",
  "The area": "Der Flächeninhalt",
  "∫H² by cotangents": "∫H² mit Kotangensgewichten",
  "∫H² by quadratic fits": "∫H² durch quadratische Anpassung",
  "{name} is right at every resolution, up to roundoff.":
    "{name} stimmt in jeder Auflösung, bis auf Rundung.",
  "{name} tends to the smooth value {smooth}; observed order {order}.":
    "{name} strebt gegen den glatten Wert {smooth}; beobachtete Ordnung {order}.",
  "{name} tends to ∫(H²−K) dA, {smooth} by quadratic fits on the finest mesh.":
    "{name} strebt gegen ∫(H²−K) dA, durch quadratische Anpassung auf dem feinsten Netz {smooth}.",
  "{name} settles; observed order {order}.":
    "{name} strebt gegen einen festen Wert; beobachtete Ordnung {order}.",
  "{name} does not tend to the smooth value {smooth}, but to about {ratio} times it.":
    "{name} strebt nicht gegen den glatten Wert {smooth}, sondern gegen etwa das {ratio}-Fache davon.",
  "{name} settles, but not at the smooth value {smooth}.":
    "{name} strebt gegen einen festen Wert, aber nicht gegen den glatten Wert {smooth}.",
  "{name} does not settle: each refinement changes it as much as the one before.":
    "{name} strebt gegen keinen festen Wert: Jede Verfeinerung ändert daran so viel wie die vorige.",
  "Of {name} two resolutions tell no more.": "{name}: Zwei Auflösungen sagen nicht mehr.",
  "The curvature of a polyhedron sits in its edges: split faces resolve them ever more sharply, and every Willmore energy grows like 1/h.":
    "Die Krümmung eines Polyeders sitzt in seinen Kanten: Geteilte Facetten lösen sie immer schärfer auf, und jede Willmore-Energie wächst wie 1/h.",
  "The circle-angle energy tends to the smooth one only where the edges follow the lines of curvature in a right-angled lattice. On other lattices its limit is larger, and where triangles are not Delaunay it has none (Bobenko and Schröder 2005, section 2). Compare it between steps, not between meshes.":
    "Die Energie der Kreiswinkel strebt nur dort gegen die glatte, wo die Kanten in einem rechtwinkligen Gitter den Krümmungslinien folgen. Auf anderen Gittern ist ihr Grenzwert größer, und wo Dreiecke nicht Delaunay sind, hat sie keinen (Bobenko und Schröder 2005, Abschnitt 2). Vergleichen Sie sie zwischen Schritten, nicht zwischen Netzen.",
  "That values converge on given meshes does not make minimisers converge: minimising any piecewise-linear Willmore energy proposed so far fails to converge to a solution of the smooth problem (Chen, Yu, Brogan, Kusner, Yang and Zigerelli, arXiv 1901.09990).":
    "Aus der Konvergenz der Werte auf gegebenen Netzen folgt nicht die der Minimierer: Für keine der bisher vorgeschlagenen stückweise linearen Willmore-Energien konvergiert die Minimierung gegen eine Lösung des glatten Problems (Chen, Yu, Brogan, Kusner, Yang und Zigerelli, arXiv 1901.09990).",

  // Goal and method
  "Goal and method": "Ziel und Verfahren",
  "L = {edges} mean edge lengths = {length}": "L = {edges} mittlere Kantenlängen = {length}",
  steps: "Schritte",
  "Choose the time step automatically": "Zeitschritt automatisch wählen",
  "First time step: {numbers}": "Erster Zeitschritt: {numbers}",
  "Circle angles β are rounded to √(β²+ε²) − ε. 0.1 never sticks; 0.01 or less lets edges align with curvature.":
    "Kreiswinkel β werden zu √(β²+ε²) − ε gerundet. 0.1 bleibt nie stecken; mit 0.01 oder weniger richten sich Kanten nach der Krümmung aus.",
  "Harmonic pre-fill of the free region": "Harmonische Vorfüllung des freien Bereichs",
  "A pure number: 0.001 is faithful to the surface, 0.1 aggressive.":
    "Eine reine Zahl: 0.001 ist der Fläche treu, 0.1 greift stark ein.",
  "Canham–Helfrich, with p = 2 only: ∫(2H − 2H₀)² dA + σA − PV. L is the radius of the sphere with the area at the start.":
    "Canham–Helfrich, nur mit p = 2: ∫(2H − 2H₀)² dA + σA − PV. L ist der Radius der Sphäre, die den Flächeninhalt des Anfangs hat.",
  "Seconds of computing, not of waiting. Either may be left empty; with a step limit the time does not count.":
    "Sekunden Rechenzeit, ohne Pausen. Beide Felder dürfen leer bleiben; mit einer Schrittgrenze zählt die Zeit nicht.",
  "Use recommended values": "Empfohlene Werte verwenden",

  // View, saving
  View: "Ansicht",
  Shading: "Schattierung",
  Smooth: "Glatt",
  Flat: "Je Facette",
  Theme: "Farbschema",
  "As the system": "Wie das System",
  Light: "Hell",
  Dark: "Dunkel",
  Wireframe: "Netzlinien",
  "Border lines": "Randlinien",
  "High contrast": "Hoher Kontrast",
  "Fit to window": "Ins Fenster einpassen",
  "Save as": "Sichern als",
  Download: "Herunterladen",
  "Nothing leaves this computer. The address of this page holds the scene; copy it to come back.":
    "Nichts verlässt diesen Rechner. Die Adresse dieser Seite enthält die Szene; kopieren Sie sie, um zurückzukommen.",
  PLY: "PLY",
  "PLY, text": "PLY, Text",
  OBJ: "OBJ",
  OFF: "OFF",
  STL: "STL",
  "STL, text": "STL, Text",
  "glTF (GLB)": "glTF (GLB)",
  "History, CSV": "Verlauf, CSV",
  "Picture, PNG": "Bild, PNG",
  "There is no picture to save.": "Es gibt kein Bild zu sichern.",
  "Save the mesh.": "Sichern Sie das Netz.",

  // Recipes, films and stored steps
  "Recipe, JSON": "Rezept, JSON",
  "The recipe gives the energy that it promised, to the last bit.":
    "Das Rezept ergibt die Energie, die es versprach, bis auf das letzte Bit.",
  "The recipe promised the energy {expected}; here it is {got}.":
    "Das Rezept versprach die Energie {expected}; hier ist sie {got}.",
  "This recipe is for the mesh “{name}”. Open that file now; the recipe follows.":
    "Dieses Rezept gehört zum Netz „{name}“. Öffnen Sie nun diese Datei; das Rezept folgt.",
  "This is not the mesh “{name}” of the recipe: its contents differ.":
    "Das ist nicht das Netz „{name}“ des Rezepts: Sein Inhalt ist ein anderer.",
  "Record a film or all steps": "Film oder alle Schritte aufnehmen",
  "A film is what the picture shows while it is recorded: a flow that runs, the history that plays, a turn of the surface. Of several pictures it has all.":
    "Ein Film ist, was das Bild während der Aufnahme zeigt: einen Fluss, der läuft, den Verlauf, der abgespielt wird, eine Drehung der Fläche. Von mehreren Bildern ist es das erste.",
  "Record film": "Film aufnehmen",
  "Stop and save": "Beenden und sichern",
  "This browser cannot record films. “Picture, PNG” and the steps can be saved.":
    "Dieser Browser kann keine Filme aufnehmen. „Bild, PNG“ und die Schritte lassen sich sichern.",
  "The browser stopped recording.": "Der Browser hat die Aufnahme abgebrochen.",
  "What was recorded until then is saved.": "Was bis dahin aufgenommen war, wird gesichert.",
  "Each step as": "Jeder Schritt als",
  Every: "Alle",
  "1 mesh, about {size} before compression; 1 GB at most.":
    "1 Netz, unkomprimiert etwa {size}; höchstens 1 GB.",
  "{meshes} meshes, about {size} before compression; 1 GB at most.":
    "{meshes} Netze, unkomprimiert etwa {size}; höchstens 1 GB.",
  "Save all steps (ZIP)": "Alle Schritte sichern (ZIP)",

  // Sharing and embedding
  "The link carries the sample or the name of the mesh, what was done to it by hand, the flow and its parameters, the region, the step, the camera and the colours, and the energy to check them by. It does not carry the theme, messages or what was undone.":
    "Der Link enthält das Beispiel oder den Namen des Netzes, was von Hand daran getan wurde, den Fluss und seine Parameter, den Bereich, den Schritt, die Kamera und die Farben, dazu die Energie zur Probe. Er enthält weder das Farbschema noch Meldungen noch, was rückgängig gemacht wurde.",
  "The edits are too large for a link: send the mesh along, saved with Download, or a recipe.":
    "Die Bearbeitungen sind zu groß für einen Link: Schicken Sie das Netz mit, gesichert mit „Herunterladen“, oder ein Rezept.",
  "The surface was edited by hand. The link does not carry that: send the mesh along, saved with Download.":
    "Die Fläche wurde von Hand bearbeitet. Das enthält der Link nicht: Schicken Sie das Netz mit, gesichert mit „Herunterladen“.",
  "The mesh itself is not in the link: send the file along.":
    "Das Netz selbst ist nicht im Link: Schicken Sie die Datei mit.",
  "The mesh itself is not in the link: send the file along. It is recognised by its SHA-256.":
    "Das Netz selbst ist nicht im Link: Schicken Sie die Datei mit. Sie wird an ihrem SHA-256 erkannt.",
  "What was changed on the way is too large for a link: send a recipe, saved with Download.":
    "Was unterwegs geändert wurde, ist zu groß für einen Link: Geben Sie ein Rezept weiter, mit „Herunterladen“ gespeichert.",
  "The painted region is too large for a link; it is not in it.":
    "Der gemalte Bereich ist zu groß für einen Link; er ist nicht darin.",
  "Copy link": "Link kopieren",
  "The link is copied.": "Der Link ist kopiert.",
  "Embed as": "Einbetten als",
  "&lt;umbilic-surface&gt;": "&lt;umbilic-surface&gt;",
  "&lt;iframe&gt;": "&lt;iframe&gt;",
  Size: "Größe",
  "Copy embed code": "Code zum Einbetten kopieren",
  "The code is copied.": "Der Code ist kopiert.",
  "Text to copy": "Text zum Kopieren",
  "The browser does not let the page copy: the text is selected, copy it with Ctrl+C.":
    "Der Browser lässt die Seite nicht kopieren: Der Text ist ausgewählt, kopieren Sie ihn mit Strg+C.",
  "Umbilic: {name}": "Umbilic: {name}",
  "Full page": "Ganze Seite",
  "Open this scene in the whole page": "Diese Szene in der ganzen Seite öffnen",
  "There is no mesh yet.": "Es gibt noch kein Netz.",
  "There is no request “{type}”.": "Es gibt keine Anfrage „{type}“.",
  "Known are {known}.": "Bekannt sind {known}.",
  "“{word}” cannot be “{text}”.": "„{word}“ kann nicht „{text}“ sein.",
  "Copy a link from the page to see how its words are written.":
    "Kopieren Sie einen Link von der Seite, um zu sehen, wie seine Wörter geschrieben werden.",
  "A step is a whole number from 0 on, not “{step}”.":
    "Ein Schritt ist eine ganze Zahl ab 0, nicht „{step}“.",
  "There is no format “{format}”.": "Es gibt kein Format „{format}“.",
  "Known are {formats}.": "Bekannt sind {formats}.",
  "A mesh is sent as `name`, with its extension, and `bytes`, an ArrayBuffer.":
    "Ein Netz wird geschickt als `name`, mit seiner Endung, und `bytes`, ein ArrayBuffer.",

  // Help
  "An <em>umbilic</em> is a point of a surface where both principal curvatures agree. The Willmore energy measures how far a surface is from being umbilic everywhere; the flow moves the mesh so that it falls.":
    "Ein <em>umbilischer Punkt</em> oder Nabelpunkt ist ein Punkt einer Fläche, in dem beide Hauptkrümmungen übereinstimmen. Die Willmore-Energie misst, wie weit eine Fläche davon entfernt ist, überall umbilisch zu sein; der Fluss bewegt das Netz so, dass sie fällt.",
  Keys: "Tasten",
  "Play or pause": "Starten oder anhalten",
  "One step": "Ein Schritt",
  "One step back": "Ein Schritt zurück",
  "Reset to the start": "Zurück zum Anfang",
  "Present: the surface alone, its words large": "Vortrag: nur die Fläche, große Schrift",
  "This help": "Diese Hilfe",
  "While presenting, also by a clicker": "Im Vortrag, auch mit dem Presenter",
  "Page ↓": "Bild ↓",
  "Page ↑": "Bild ↑",
  Esc: "Esc",
  "Play or pause; at the end of a figure, the next one":
    "Starten oder anhalten; am Ende einer Abbildung die nächste",
  "Back to the start; at the start, the figure before":
    "Zurück zum Anfang; am Anfang die Abbildung davor",
  "Hide or show the line of readings": "Zeile der Messwerte aus- oder einblenden",
  "End the presentation": "Den Vortrag beenden",
  "{energy} · step {step} · {title}": "{energy} · Schritt {step} · {title}",
  "Language / Sprache": "Language / Sprache",
  "The page changes its language when it is loaded again. Its address keeps the scene; a mesh from a file has to be opened again.":
    "Die Seite wechselt ihre Sprache, wenn sie neu geladen wird. Ihre Adresse behält die Szene; ein Netz aus einer Datei muss neu geöffnet werden.",
  "Load again": "Neu laden",
  "Close the panel": "Bedienfeld schließen",
  "Swipe down to close": "Zum Schließen nach unten wischen",
  "Single-key shortcuts": "Bedienung mit einzelnen Tasten",
  "Drag turns the surface; with <kbd>Shift</kbd>, the right button or two fingers it moves; wheel or pinch zooms; a double click fits it. With the picture focused, arrow keys turn, <kbd>+</kbd> and <kbd>−</kbd> zoom, <kbd>[</kbd> and <kbd>]</kbd> roll, <kbd>0</kbd> fits, <kbd>Home</kbd> returns to the first view.":
    "Ziehen dreht die Fläche; mit <kbd>Umschalt</kbd>, der rechten Taste oder zwei Fingern wird sie verschoben; Rad oder Spreizen zoomt; ein Doppelklick passt sie ein. Hat das Bild den Fokus, drehen die Pfeiltasten, <kbd>+</kbd> und <kbd>−</kbd> zoomen, <kbd>[</kbd> und <kbd>]</kbd> rollen, <kbd>0</kbd> passt ein, <kbd>Pos1</kbd> kehrt zur ersten Ansicht zurück.",

  // The picture
  "Surface: none yet": "Fläche: noch keine",
  "Surface: {name}": "Fläche: {name}",
  "Surface: {name}, {caption}": "Fläche: {name}, {caption}",
  "Surface: {name}, step {step}, energy {energy}, area {area}":
    "Fläche: {name}, Schritt {step}, Energie {energy}, Inhalt {area}",
  "Drawn with {name}: {reason}.": "Gezeichnet mit {name}: {reason}.",
  "the address asks for it": "so verlangt es die Adresse",
  "this browser offers it": "dieser Browser bietet es an",
  "this browser has no WebGPU, or the page is not served securely":
    "dieser Browser hat kein WebGPU, oder die Seite kommt nicht über eine sichere Verbindung",
  "this browser has no WebGL2": "dieser Browser hat kein WebGL2",
  "{reason}; there is no WebGL2 either": "{reason}; WebGL2 gibt es auch nicht",
  "Use a current Chrome, Edge, Firefox or Safari, over https or on localhost, and switch on hardware acceleration in its settings.":
    "Nehmen Sie ein aktuelles Chrome, Edge, Firefox oder Safari, über https oder auf localhost, und schalten Sie in den Einstellungen die Hardwarebeschleunigung ein.",
  "the viewer could not be loaded: {reason}": "die Anzeige konnte nicht geladen werden: {reason}",
  "Check the connection and reload the page.":
    "Prüfen Sie die Verbindung und laden Sie die Seite neu.",
  "the browser took the WebGL context away": "der Browser hat den WebGL-Kontext weggenommen",
  "no picture": "kein Bild",
  rebuilding: "wird neu aufgebaut",
  "No picture here": "Hier kein Bild",
  "WebGPU is part of current Chrome and Edge (113 or later), Safari 26 and Firefox 141 or later; the page must come from <code>https://</code> or <code>localhost</code>. WebGL2, which will do as well, is part of every browser of the last years. Everything else on this page works without the picture: the flow runs, the readings and the plot follow it, and the mesh can be saved.":
    "WebGPU gehört zu heutigem Chrome und Edge (ab 113), Safari 26 und Firefox ab 141; die Seite muss von <code>https://</code> oder <code>localhost</code> kommen. WebGL2, das ebenso genügt, ist in jedem Browser der letzten Jahre. Alles andere auf dieser Seite geht auch ohne Bild: Der Fluss läuft, Messwerte und Kurve folgen ihm, und das Netz lässt sich sichern.",

  // Links, the solver's comings and goings
  "This link shows the mesh “{mesh}”, a file on its author’s computer.":
    "Dieser Link zeigt das Netz „{mesh}“, eine Datei auf dem Rechner seines Verfassers.",
  "Open that file here; the scene then follows.":
    "Öffnen Sie diese Datei hier; die Szene folgt dann.",
  "“{name}” is not the file of the link, which shows “{mesh}”; it is opened all the same.":
    "„{name}“ ist nicht die Datei des Links, der „{mesh}“ zeigt; geöffnet wird sie trotzdem.",
  "The scene is as it was sent: {symbol} = {here}.":
    "Die Szene ist so, wie sie verschickt wurde: {symbol} = {here}.",
  "The scene is as it was sent to six digits: {symbol} = {here}, {apart} from the {sent} of the link.":
    "Die Szene ist auf sechs Stellen so, wie sie verschickt wurde: {symbol} = {here}, um {apart} neben dem Wert {sent} des Links.",
  "The scene is not as it was sent: {symbol} = {here} at step {step}, where the link says {sent}; that is {apart} off.":
    "Die Szene ist nicht so, wie sie verschickt wurde: {symbol} = {here} bei Schritt {step}, wo der Link {sent} angibt; das ist um {apart} daneben.",
  "The link shows step {step}; here the flow ends at step {here}.":
    "Der Link zeigt Schritt {step}; hier endet der Fluss bei Schritt {here}.",
  "The mesh is not the file of the link.": "Das Netz ist nicht die Datei des Links.",
  "Perhaps the file is not the one the link was made with.":
    "Vielleicht ist die Datei nicht die, mit der der Link gemacht wurde.",
  "The link was made by version {theirs} of the solver; this is version {ours}.":
    "Der Link stammt von Version {theirs} des Lösers; dies ist Version {ours}.",
  "The same version should give the same numbers; please report this, with the link.":
    "Dieselbe Version sollte dieselben Zahlen ergeben; bitte melden Sie das, mit dem Link.",
  "A new version is ready: reload the page to use it.":
    "Eine neue Version liegt bereit: Laden Sie die Seite neu, um sie zu benutzen.",
  "The solver stopped unexpectedly ({reason}); a new one goes on from step {step}.":
    "Der Löser ist unerwartet stehen geblieben ({reason}); ein neuer macht ab Schritt {step} weiter.",
  "If it was short of memory, close other tabs or use a mesh with fewer faces.":
    "Falls der Speicher knapp war, schließen Sie andere Tabs oder nehmen Sie ein Netz mit weniger Facetten.",
  "it could not be loaded": "er konnte nicht geladen werden",
  "The solver could not be started.": "Der Löser konnte nicht gestartet werden.",
  "Reload the page; its address keeps the scene.":
    "Laden Sie die Seite neu; ihre Adresse behält die Szene.",
  "The computation was ended; the surface is as after step {step}.":
    "Die Rechnung wurde beendet; die Fläche ist wie nach Schritt {step}.",

  // The viewer
  "WebGPU offers no graphics adapter": "WebGPU bietet keine Grafikkarte an",

  // Recipes that cannot be followed, and what is said of flows
  "{label} ({why})": "{label} ({why})",
  "closed surfaces only": "nur geschlossene Flächen",
  "only where a part is held, or open": "nur wo ein Teil festgehalten oder die Fläche offen ist",
  "rounds off the cone of an angle at 0; goes to 0 at the end":
    "rundet den Kegel eines Winkels bei 0 ab; geht am Ende gegen 0",
  "inverse of the Hessian, from the last steps":
    "Inverse der Hesse-Matrix, aus den letzten Schritten",
  "what the line search finds": "was die Liniensuche findet",
  "This recipe runs about {steps} steps.": "Dieses Rezept rechnet etwa {steps} Schritte.",
  "This link runs about {steps} steps.": "Dieser Link rechnet etwa {steps} Schritte.",
  "Run them": "Rechnen",
  "Leave it": "Lassen",

  // Slides
  "Willmore flow in eight slides": "Willmore-Fluss auf acht Folien",
  "Willmore flow, live": "Willmore-Fluss, live",
  "How a surface loses what it need not have: four papers in eight slides, and every picture is a computation.":
    "Wie eine Fläche verliert, was sie nicht haben muss: vier Arbeiten auf acht Folien, und jedes Bild ist eine Rechnung.",
  "<kbd>→</kbd> or a clicker goes on, <kbd>Space</kbd> plays and pauses, a drag turns the surface.":
    "<kbd>→</kbd> oder ein Klicker blättert weiter, <kbd>Leertaste</kbd> startet und hält an, Ziehen dreht die Fläche.",
  "A bumpy sphere that becomes round": "Eine beulige Sphäre, die rund wird",
  "What is to become small": "Was klein werden soll",
  "The <em>Willmore energy</em> measures how far a surface is from curving alike in all directions:":
    "Die <em>Willmore-Energie</em> misst, wie weit eine Fläche davon entfernt ist, in allen Richtungen gleich gekrümmt zu sein:",
  "It is zero for a round sphere, whatever its size. Among tori the least is 2π², at the Clifford torus, with R/r = √2: Willmore’s conjecture, proved by Marques and Neves.":
    "Sie ist null für eine runde Sphäre, wie groß sie auch ist. Unter den Tori ist der kleinste Wert 2π², beim Clifford-Torus mit R/r = √2: Willmores Vermutung, bewiesen von Marques und Neves.",
  "A thin torus that thickens into the Clifford torus":
    "Ein dünner Torus, der zum Clifford-Torus wird",
  "A thin torus thickens. ∫H² =": "Ein dünner Torus wird dicker. ∫H² =",
  "; the least of all tori is 2π² = 19.739.": "; der kleinste Wert aller Tori ist 2π² = 19.739.",
  "Circles instead of curvatures": "Kreise statt Krümmungen",
  "Bobenko and Schröder, 2005": "Bobenko und Schröder, 2005",
  "Every edge has an angle β between the circumcircles of its two triangles. About a vertex they add up to at least 2π:":
    "Jede Kante hat einen Winkel β zwischen den Umkreisen ihrer beiden Dreiecke. Um eine Ecke ergeben sie zusammen mindestens 2π:",
  "Möbius transformations take circles to circles, so the sum has the symmetry of the smooth energy. It vanishes exactly for convex Delaunay meshes inscribed in a sphere.":
    "Möbius-Transformationen führen Kreise in Kreise über, die Summe hat also die Symmetrie der glatten Energie. Sie verschwindet genau für konvexe Delaunay-Netze, die einer Sphäre einbeschrieben sind.",
  "A subdivided icosahedron that becomes a sphere":
    "Ein unterteiltes Ikosaeder, das zur Sphäre wird",
  "The flat-sided icosahedron starts at W = 60π = 188.5 and ends at 0. Here W =":
    "Das Ikosaeder mit ebenen Seiten beginnt bei W = 60π = 188.5 und endet bei 0. Hier ist W =",
  after: "nach",
  "steps.": "Schritten.",
  "Holes and bends": "Löcher und Bögen",
  "Bobenko and Schröder, figures 9 and 10": "Bobenko und Schröder, Abbildungen 9 und 10",
  "The flow is of fourth order: a boundary may keep its position <em>and</em> its tangent planes. A bend relaxes between two clamped ends; a hole is closed without a crease.":
    "Der Fluss ist von vierter Ordnung: Ein Rand kann seine Lage <em>und</em> seine Tangentialebenen behalten. Ein Bogen entspannt sich zwischen zwei eingespannten Enden; ein Loch wird ohne Knick geschlossen.",
  "A bent pipe that relaxes between clamped ends":
    "Ein gebogenes Rohr, das sich zwischen eingespannten Enden entspannt",
  "A six-sided hole that is filled smoothly": "Ein sechsseitiges Loch, das glatt gefüllt wird",
  Vesicles: "Vesikel",
  "Gruber and Aulisa, 2020": "Gruber und Aulisa, 2020",
  "A cell’s membrane bends and hardly stretches. The p-Willmore flow keeps area and volume, by two multipliers, while this falls:":
    "Die Membran einer Zelle biegt sich und dehnt sich kaum. Der p-Willmore-Fluss hält Flächeninhalt und Volumen mit zwei Multiplikatoren fest, während dies fällt:",
  "With the volume led down to 0.6 of the ball’s of that area, a vesicle becomes what a red blood cell is: a biconcave disc.":
    "Wird das Volumen auf 0.6 dessen der Kugel mit diesem Flächeninhalt gesenkt, so wird ein Vesikel, was ein rotes Blutkörperchen ist: eine bikonkave Scheibe.",
  "A vesicle that is deflated": "Ein Vesikel, aus dem Volumen weicht",
  ", area": ", Flächeninhalt",
  ", volume": ", Volumen",
  "Patches that nobody sees": "Flicken, die niemand sieht",
  "Xu and Zhang, 2006": "Xu und Zhang, 2006",
  "Where a patch ends, Willmore flow leaves the curvature free to jump. The sixth-order flow of least variation of mean curvature does not:":
    "Wo ein Flicken endet, darf die Krümmung beim Willmore-Fluss springen. Beim Fluss sechster Ordnung, dem der kleinsten Variation der mittleren Krümmung, darf sie es nicht:",
  "Colours show mean curvature: above the patch by Willmore flow, below by the variation of H.":
    "Die Farben zeigen die mittlere Krümmung: oben der Flicken des Willmore-Flusses, unten der nach der Variation von H.",
  "Four bumps, patched by Willmore flow": "Vier Hügel, geflickt vom Willmore-Fluss",
  "Four bumps, patched by the variation of mean curvature":
    "Vier Hügel, geflickt nach der Variation der mittleren Krümmung",
  "Four bumps, patched by four flows": "Vier Hügel, geflickt von vier Flüssen",
  "Jump of H at the rim, relative:": "Sprung von H am Rand des Flickens, relativ:",
  "above,": "oben,",
  below: "unten",
  "The same points, better edges": "Dieselben Punkte, bessere Kanten",
  "Brink and Alboul": "Brink und Alboul",
  "Edges may be flipped while every vertex stays: always the flip that takes most off the area, the Willmore energy, or the localised Willmore energy.":
    "Kanten können umgelegt werden, während jede Ecke bleibt: immer der Flip, der am meisten vom Flächeninhalt, von der Willmore-Energie oder von der lokalisierten Willmore-Energie nimmt.",
  "Their conjecture, that a flip lowers the area exactly when it lowers the localised energy, holds where the four points are nearly coplanar. In general it is false: four integer points refute it.":
    "Ihre Vermutung, dass ein Flip den Flächeninhalt genau dann senkt, wenn er die lokalisierte Energie senkt, gilt, wo die vier Punkte fast in einer Ebene liegen. Im Allgemeinen ist sie falsch: Vier ganzzahlige Punkte widerlegen sie.",
  "A face with creases, smoothed by edge flips":
    "Ein Gesicht mit Knicken, geglättet durch Kantenflips",
  "Ten flips a step:": "Zehn Flips je Schritt:",
  "flips so far, W =": "Flips bisher, W =",
  "Now yours": "Nun Ihre",
  "Open the page": "Öffnen Sie die Seite",
  "and drop a mesh on it: OBJ, OFF, PLY or STL. Nothing leaves the computer.":
    "und ziehen Sie ein Netz darauf: OBJ, OFF, PLY oder STL. Nichts verlässt den Rechner.",
  "These slides are an ordinary page. Each surface in them is one line:":
    "Diese Folien sind eine gewöhnliche Seite. Jede Fläche darin ist eine Zeile:",
  "“Share” on the page writes that line for the scene you have.":
    "„Teilen“ auf der Seite schreibt diese Zeile für die Szene, die Sie haben.",
  "A knotted tube that cannot untie itself": "Ein verknoteter Schlauch, der sich nicht lösen kann",
  "A knotted tube": "Ein verknoteter Schlauch",
  Slides: "Folien",
  "Previous slide (←, Page Up)": "Vorige Folie (←, Bild auf)",
  "Previous slide": "Vorige Folie",
  "Next slide (→, Page Down)": "Nächste Folie (→, Bild ab)",
  "Next slide": "Nächste Folie",
  "Full screen (F)": "Vollbild (F)",
  "Full screen": "Vollbild",
};
