// @ts-check
// The slides in German: the English text is the key.

/** @type {Record<string, string>} */
export const german = {
  "Willmore flow in nine slides": "Willmore-Fluss auf neun Folien",
  "Willmore flow, live": "Willmore-Fluss, live",
  "How a surface loses what it need not have: four papers and an eversion of the sphere in nine slides, and every picture is a computation.":
    "Wie eine Fläche verliert, was sie nicht haben muss: vier Arbeiten und eine umgestülpte Sphäre auf neun Folien, und jedes Bild ist eine Rechnung.",
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
  "A sphere, turned inside out": "Eine Sphäre, umgestülpt",
  "Francis, Sullivan, Kusner, Brakke, Hartman and Chappell, 1997":
    "Francis, Sullivan, Kusner, Brakke, Hartman und Chappell, 1997",
  "A surface may pass through itself, but not crease. Even so a sphere can be turned inside out: Smale’s theorem of 1958. Every way leads through a point where four sheets meet, and there the bending energy is at least":
    "Eine Fläche darf sich selbst durchdringen, aber nicht knicken. Auch so lässt sich eine Sphäre umstülpen: Smales Satz von 1958. Jeder Weg führt durch einen Punkt, in dem vier Blätter zusammenkommen, und dort ist die Biegeenergie mindestens",
  "Morin’s surface has just that much, and is a saddle. Pushed to either side it flows down to the round sphere, to 4π. One way backwards and the other forwards: a film, computed here and now.":
    "Morins Fläche hat genau so viel und ist ein Sattel. Nach beiden Seiten angestoßen, fließt sie hinab zur runden Sphäre, zu 4π. Der eine Weg rückwärts und der andere vorwärts: ein Film, hier und jetzt gerechnet.",
  "A sphere that is turned inside out": "Eine Sphäre, die umgestülpt wird",
  ", from 4π = 12.57 up to 16π = 50.27 and down again; volume":
    ", von 4π = 12.57 hinauf zu 16π = 50.27 und wieder hinab; Volumen",
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
