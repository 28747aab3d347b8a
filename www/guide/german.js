// @ts-check
// The guide in German: the English text is the key.

/** @type {Record<string, string>} */
export const german = {
  Guide: "Anleitung",
  "A first look": "Ein erster Blick",
  "For the lecture": "Für die Vorlesung",
  "A mesh of your own": "Ein eigenes Netz",
  "A first look · Umbilic": "Ein erster Blick · Umbilic",
  "For the lecture · Umbilic": "Für die Vorlesung · Umbilic",
  "A mesh of your own · Umbilic": "Ein eigenes Netz · Umbilic",

  "A surface that is bent more than it need be moves until it is not. That motion is a flow, and here you watch it.":
    "Eine Fläche, die stärker gebogen ist, als sie sein müsste, bewegt sich, bis sie es nicht mehr ist. Diese Bewegung ist ein Fluss, und hier sieht man ihm zu.",
  "A bumpy sphere that becomes round": "Eine beulige Sphäre, die rund wird",
  "Press <b>Play</b>. Drag to turn it, scroll to come nearer.":
    "<b>Abspielen</b> drücken. Ziehen dreht die Fläche, das Mausrad holt sie näher.",
  "What you see": "Was man sieht",
  "The number that falls is the <em>Willmore energy</em>: it is large where a surface curves more in one direction than in the other, and zero for a round sphere. At every step the surface moves so that it becomes smaller.":
    "Die Zahl, die fällt, ist die <em>Willmore-Energie</em>: Sie ist groß, wo sich eine Fläche in einer Richtung stärker krümmt als in der anderen, und null für eine runde Sphäre. In jedem Schritt bewegt sich die Fläche so, dass sie kleiner wird.",
  "Between the steps the picture moves smoothly, at the pace of what your eye sees change. The ticks on the curve are the steps that were computed; all numbers and files are of one of those.":
    "Zwischen den Schritten bewegt sich das Bild gleitend, so schnell, wie das Auge Veränderung sieht. Die Striche an der Kurve sind die gerechneten Schritte; alle Zahlen und Dateien gehören zu einem von ihnen.",
  "Colours show the mean curvature: one end of the scale where the surface bulges, the other where it is dented. The scale is held for the whole run, so that the same colour means the same curvature at the end as at the start.":
    "Die Farben zeigen die mittlere Krümmung: das eine Ende der Skala, wo sich die Fläche vorwölbt, das andere, wo sie eingedellt ist. Die Skala bleibt während des ganzen Laufs, sodass dieselbe Farbe am Ende dieselbe Krümmung bedeutet wie am Anfang.",
  "Some go elsewhere": "Manche gehen anderswohin",
  "A sphere is not always the goal. A doughnut cannot become a sphere without tearing; among all of them one is bent least, the torus of Clifford.":
    "Nicht immer ist eine Sphäre das Ziel. Ein Ring kann keine Sphäre werden, ohne zu reißen; unter allen Ringen ist einer am wenigsten gebogen, der Torus von Clifford.",
  "A thin torus that thickens into the Clifford torus":
    "Ein dünner Torus, der zum Clifford-Torus wird",
  "∫H² comes down towards 2π² = 19.739, the least of all tori: a conjecture of Willmore’s, proved in 2012.":
    "∫H² sinkt gegen 2π² = 19,739, den kleinsten Wert aller Tori: eine Vermutung Willmores, bewiesen 2012.",
  "Go on": "Weiter",
  "The name of the surface, at the top, opens the library: samples, and every figure of four papers.":
    "Der Name der Fläche, oben, öffnet die Bibliothek: Beispiele und jede Abbildung aus vier Arbeiten.",
  "<kbd>1</kbd> to <kbd>5</kbd> open the tabs at the right: the surface, its flow, measurements, comparisons, and what can be taken along.":
    "<kbd>1</kbd> bis <kbd>5</kbd> öffnen die Reiter rechts: die Fläche, ihren Fluss, Messungen, Vergleiche und was sich mitnehmen lässt.",
  "Drop a mesh on the page. It stays on your machine: nothing is uploaded.":
    "Ein Netz auf die Seite ziehen. Es bleibt auf diesem Rechner: Nichts wird hochgeladen.",

  "A projector, a clicker and one key: <kbd>F</kbd> fills the window with the surface, in large type and strong colours.":
    "Ein Projektor, ein Klicker und eine Taste: <kbd>F</kbd> füllt das Fenster mit der Fläche, in großer Schrift und kräftigen Farben.",
  "A subdivided icosahedron that becomes a sphere":
    "Ein unterteiltes Ikosaeder, das zur Sphäre wird",
  "Figure 6 of Bobenko and Schröder: from W = 60π to 0.":
    "Abbildung 6 von Bobenko und Schröder: von W = 60π nach 0.",
  Present: "Vorführen",
  "<kbd>F</kbd> begins and ends it. The clicker’s keys, Page Down and Page Up, go on to the next surface and back; <kbd>Space</kbd> plays and pauses.":
    "<kbd>F</kbd> beginnt und beendet es. Die Tasten des Klickers, Bild ab und Bild auf, gehen zur nächsten Fläche und zurück; die <kbd>Leertaste</kbd> spielt ab und hält an.",
  "Warnings and diagnoses stay with you: the audience sees the surface, its name and the number that falls.":
    "Warnungen und Diagnosen bleiben für einen selbst: Das Publikum sieht die Fläche, ihren Namen und die Zahl, die fällt.",
  "<kbd>L</kbd> plays again and again while you speak; <kbd>[</kbd> and <kbd>]</kbd> change the speed.":
    "<kbd>L</kbd> spielt immer wieder ab, während man spricht; <kbd>[</kbd> und <kbd>]</kbd> ändern das Tempo.",
  "The page works without a connection after the first visit. Open it once where you prepare the lecture.":
    "Nach dem ersten Besuch arbeitet die Seite ohne Verbindung. Einmal dort öffnen, wo die Vorlesung vorbereitet wird.",
  "Prepare a scene": "Eine Szene vorbereiten",
  "Everything you set up is in the address: the surface, the flow, the colours, the camera and the step. Make a bookmark of it, or copy the link under Share. Whoever opens it is told whether their machine found the same energy as yours.":
    "Alles Eingerichtete steht in der Adresse: die Fläche, der Fluss, die Farben, die Kamera und der Schritt. Ein Lesezeichen genügt, oder der Link unter Teilen. Wer ihn öffnet, erfährt, ob sein Rechner dieselbe Energie gefunden hat.",
  "Two flows side by side say more than one. Under Compare, <b>Flow</b> sets the mean-curvature flow beside it: one rounds, the other shrinks. <kbd>B</kbd> shows one in the place of the other.":
    "Zwei Flüsse nebeneinander sagen mehr als einer. Unter Vergleichen stellt <b>Fluss</b> den mittleren Krümmungsfluss daneben: Der eine rundet, der andere schrumpft. <kbd>B</kbd> zeigt einen an der Stelle des anderen.",
  "Library, <b>The sphere turned inside out</b>: one press computes an eversion and plays it as a film, from the sphere over Morin’s surface to the sphere with its other side out.":
    "Bibliothek, <b>Die Sphäre, umgestülpt</b>: Ein Druck rechnet eine Umstülpung und spielt sie als Film, von der Sphäre über Morins Fläche zur Sphäre, die ihre andere Seite nach außen kehrt.",
  "In your own slides": "In eigenen Folien",
  "Slides made of HTML hold live surfaces: one script, one element, no account.":
    "Folien aus HTML können lebende Flächen enthalten: ein Skript, ein Element, kein Konto.",
  "For other programs there is the film: Share, <b>Record</b>, play, stop.":
    "Für andere Programme gibt es den Film: Teilen, <b>Aufnehmen</b>, abspielen, beenden.",
  "Nine slides made that way": "Neun Folien, die so gemacht sind",

  "Drop a file on the page. It is read, counted and checked on your machine; what is odd about it is said before anything is changed.":
    "Eine Datei auf die Seite ziehen. Sie wird auf diesem Rechner gelesen, gezählt und geprüft; was an ihr auffällt, wird gesagt, bevor sich etwas ändert.",
  "A noisy scan that is smoothed a little": "Ein verrauschter Scan, der ein wenig geglättet wird",
  "A scan with noise: a set amount of smoothing takes the noise and leaves the features.":
    "Ein Scan mit Rauschen: Eine feste Menge Glättung nimmt das Rauschen und lässt die Merkmale.",
  "What was found": "Was gefunden wurde",
  "Under Surface you read what the mesh is: its counts, its holes, its smallest angle, whether it passes through itself, and what a repair would change. Where something can be done about it there is a button, and every change can be undone. Vertices and faces have the numbers of your file, from 1 in OBJ and from 0 in other formats; <code>--free</code> and <code>--fixed</code> on the command line read them so.":
    "Unter Fläche steht, was das Netz ist: seine Anzahlen, seine Löcher, sein kleinster Winkel, ob es sich selbst durchdringt und was eine Reparatur ändern würde. Wo sich etwas tun lässt, gibt es einen Knopf, und jede Änderung lässt sich zurücknehmen. Ecken und Facetten haben die Nummern der Datei, in OBJ von 1 an, in anderen Formaten von 0 an; <code>--free</code> und <code>--fixed</code> auf der Kommandozeile lesen sie so.",
  "Which flow": "Welcher Fluss",
  "You want": "Gewünscht",
  Take: "Zu nehmen",
  "the noise gone, the features kept": "kein Rauschen, Merkmale erhalten",
  "Willmore by circle angles, goal: smooth": "Willmore nach Kreiswinkeln, Ziel: glätten",
  "the roundest surface of its kind": "die rundeste Fläche ihrer Art",
  "p-Willmore with p = 2, on closed surfaces": "p-Willmore mit p = 2, auf geschlossenen Flächen",
  "the shape of a red blood cell": "die Form eines roten Blutkörperchens",
  "p-Willmore with area and volume kept": "p-Willmore, Inhalt und Volumen erhalten",
  "a hole closed so that no light shows where":
    "ein Loch so geschlossen, dass kein Licht verrät, wo",
  "Fill holes, then Minimal curvature variation, sixth order":
    "Löcher füllen, dann kleinste Krümmungsänderung, sechste Ordnung",
  "better triangles and the same shape": "bessere Dreiecke und dieselbe Form",
  "Even out the triangles": "Dreiecke angleichen",
  "When it ends": "Wenn es endet",
  "“Converged” means at rest by a test that does not depend on the step size. A stall, a pinch, a collapse and a limit are called that; <b>Why?</b> says what happened, shows the place, and offers what helps.":
    "„Konvergiert“ heißt: in Ruhe nach einer Prüfung, die nicht von der Schrittweite abhängt. Ein Stocken, ein Abschnüren, ein Zusammenbruch und eine Grenze werden so genannt; <b>Warum?</b> sagt, was geschehen ist, zeigt die Stelle und bietet an, was hilft.",
  "Take it along": "Mitnehmen",
  "The mesh in the format you need, the table of all steps, a picture, a film, or one mesh of each step.":
    "Das Netz im nötigen Format, die Tabelle aller Schritte, ein Bild, einen Film oder ein Netz jedes Schritts.",
  "A <em>recipe</em>: what was done, so that it can be done again to the last bit, here or on the command line.":
    "Ein <em>Rezept</em>: was getan wurde, sodass es sich bis aufs letzte Bit wiederholen lässt, hier oder auf der Kommandozeile.",
};
