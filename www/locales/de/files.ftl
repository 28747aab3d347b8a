# Netzdateien: src/io/error.rs.

## Stellen und Formate

place-line = Zeile { $line }
place-byte = Byte { $byte }
format-obj = OBJ
format-off = OFF
format-ply = PLY
format-ply-ascii = PLY (ASCII)
format-ply-big = PLY (big-endian)
format-stl = binäres STL
format-stl-ascii = STL (ASCII)
format-glb = GLB
format-gltf = glTF
format-3mf = 3MF
format-vtk = VTK
format-vtp = VTK-XML
format-msh = MSH

## Was in einer Datei steht, und was stehen sollte

found-end-of-line = das Ende der Zeile
found-end-of-file = das Ende der Datei
found-nothing = nichts
found-word = `{ $word }`
expected-keyword = `{ $word }`
expected-coordinate = die Koordinate { $axis }
expected-vertex = eine Ecke
expected-face = eine Facette
expected-vertex-index = ein Eckenindex
expected-obj-corner = ein Eckenindex wie 7, 7/1 oder 7//2
expected-vertex-count = die Zahl der Ecken
expected-off-or-vertex-count = OFF oder die Zahl der Ecken
expected-face-count = die Zahl der Facetten
expected-corner-count = die Zahl der Ecken der Facette
expected-number = eine Zahl
expected-property-name = der Name der Eigenschaft
expected-element-name = der Name des Elements
expected-element-count = die Zahl der Elemente
expected-other-element = eine Zeile eines anderen Elements
expected-list-length = die Länge einer Liste
expected-integer-type = ein ganzzahliger Typ für die Länge einer Liste
expected-number-type = ein Typ wie float oder uchar
expected-one-element-each = Ecken und Facetten in je einem Element
expected-vertex-properties = je eine Eigenschaft `x`, `y` und `z` im Element vertex
expected-face-property = eine Liste `vertex_indices` ganzer Zahlen im Element face
expected-cell-count = die Anzahl oder das Ende der Zellen
expected-cell-type = eine bekannte Art von Zelle
expected-vertex-number = eine Nummer, die keine andere Ecke hat
expected-xml-element = `{ $name }` von XML
expected-xml-attribute = das Attribut { $name } mit passendem Wert
expected-json-value = wohlgeformtes JSON
expected-json-member = ein passendes `{ $name }`
expected-scene-node = die Nummer eines Knotens, der an einer Stelle der Szene und nicht in sich selbst steht
expected-base64 = vollständiger Base64-Text
expected-compressed = unbeschädigte zlib-Daten
expected-model-object = die Nummer eines Objekts, das nicht Teil von sich selbst ist
expected-transform = zwölf Zahlen

## Dateien, die abgelehnt werden

read-empty = die Datei ist leer
    .hint = Prüfen Sie, ob der Export oder das Herunterladen zu Ende kam.
read-unknown-format = `{ $name }` ist nicht als Netz zu erkennen
    .hint = Öffnen Sie eine Datei mit einer dieser Endungen: { $known }.
read-substituted = { $what ->
    [git-lfs] dies ist ein Verweis von Git LFS und nicht die Datei selbst
   *[html] dies ist eine HTML-Seite und kein Netz
}
    .hint = { $what ->
        [git-lfs] Holen Sie die Datei mit `git lfs pull` oder über den Download auf ihrer Seite.
       *[html] Der Link führte zu einer Seite über die Datei oder zu einem Fehler: Laden Sie die Datei selbst herunter.
    }
read-required-extension = ohne seine Erweiterung { $name }, die hier unbekannt ist, kann das glTF nicht gelesen werden
    .hint = Exportieren Sie die Fläche ohne sie oder als OBJ, PLY oder STL.
read-unsupported = Dateien der Art { $what ->
    [vtk-data-set] VTK ohne polygonale Daten oder unstrukturiertes Gitter
    [vtk-compressor] VTK, anders als durch zlib komprimiert,
    [msh-version] MSH einer anderen Version als 1, 2 oder 4
    [gltf-version] glTF einer anderen Version als 2
    [gltf-external] glTF mit Daten in anderen Dateien
    [gltf-draco] glTF, durch Draco komprimiert,
    [gltf-meshopt] glTF, durch meshopt komprimiert,
    [obj-free-form] OBJ, allein mit Freiformflächen,
   *[nd-off] höherdimensionales OFF
} lassen sich nicht lesen
    .hint = { $what ->
        [gltf-external] Öffnen Sie die .gltf zusammen mit den Dateien neben ihr, oder exportieren Sie eine GLB.
        [gltf-draco] Exportieren Sie ohne Kompression.
        [gltf-meshopt] Exportieren Sie ohne Kompression.
        [msh-version] Sichern Sie sie als MSH 4.1 oder 2.2.
        [obj-free-form] Exportieren Sie sie als Dreiecke: Die meisten Programme haben eine Einstellung, wie fein.
       *[other] Exportieren Sie die Fläche als OBJ, PLY oder STL.
    }
read-not-text = { $format }: Byte { $offset } ist kein Text
    .hint = Die Datei ist binär oder UTF-16-Text; sichern Sie sie als UTF-8, oder geben Sie ihr die richtige Endung.
read-syntax = { $format }, { $place }: { $found } gefunden, erwartet wurde { $expected }
    .hint = Sehen Sie an dieser Stelle der Datei nach, oder exportieren Sie sie neu.
read-decimal-comma = { $format }, { $place }: { $found } gefunden, erwartet wurde { $expected }
    .hint = Exportieren Sie mit Dezimalpunkt statt Dezimalkomma.
read-index-out-of-range = { $format }, { $place }: Eine Facette nennt Ecke { $index }, die Datei hat { $vertices }
    .hint = { $format ->
        [OBJ] OBJ zählt Ecken ab 1 oder ab -1 rückwärts. Exportieren Sie die Datei neu.
        [MSH] MSH nennt Ecken bei eigenen Nummern. Exportieren Sie die Datei neu.
       *[other] Dieses Format zählt Ecken ab 0. Exportieren Sie die Datei neu.
    }
read-non-finite-vertex = { $place }: Ecke Nummer { $number } (ab 1 gezählt) ist nicht endlich
    .hint = Entfernen Sie die Ecke oder geben Sie ihr eine Lage, und exportieren Sie neu.
read-truncated = die Datei bricht ab: { $needed } Bytes werden ab Byte { $offset } gebraucht, { $available } sind da
    .hint = Das Herunterladen oder Kopieren endete wohl zu früh; holen Sie die Datei noch einmal.
read-count-too-large = { $place } kündigt { $count } { $what ->
    [bytes] Bytes Speicher
    [vertices] Ecken
    [faces] Facetten
    [corners] Ecken von Facetten
   *[elements] Elemente
} an, höchstens { $at_most } sind möglich
    .hint = Die Anzahl ist falsch, oder die Datei bricht ab.
read-no-faces = die Datei hat { $vertices ->
    [one] { $vertices } Ecke
   *[other] { $vertices } Ecken
} und keine Facetten
    .hint = { $vertices ->
        [0] Prüfen Sie, ob die Datei ist, was ihr Name sagt.
       *[other] Punktwolken und Kurven haben keine Fläche; öffnen Sie ein Netz.
    }

## Besonderheiten gelesener Dateien

oddity-transcoded = Der Text ist UTF-16; so wurde er gelesen.
oddity-other-ending = Der Name endet auf .{ $ending }, der Inhalt ist { $format }.
oddity-short-faces = Facetten mit weniger als drei Ecken wurden weggelassen: { $count }, zuerst bei { $first }.
oddity-unplaced-vertices = { $count ->
    [one] { $count } Ecke ohne Ort, die keine Fläche benutzt, liegt
   *[other] { $count } Ecken ohne Ort, die keine Fläche benutzt, liegen
} nun bei der ersten Ecke (die erste: { $first }).
oddity-nothing-to-build = Das Modell sagt nicht, was zu bauen ist; alle seine Objekte wurden gelesen.
oddity-other-lines = Zeilen, die nicht zu einem Polygonnetz gehören, wurden übergangen: { $count }, zuerst bei { $first }.
oddity-lines-left = { $count ->
    [one] { $count } Zeile nach dem, was der Kopf zählt, blieb
   *[other] { $count } Zeilen nach dem, was der Kopf zählt, blieben
} unbeachtet.
oddity-bytes-left = { $count ->
    [one] { $count } Byte nach dem Ende des Netzes blieb
   *[other] { $count } Bytes nach dem Ende des Netzes blieben
} unbeachtet.
oddity-no-end = Der letzte Körper hat kein Ende; vielleicht bricht die Datei ab.
oddity-uncounted = Der Kopf zählt { $announced ->
    [0] keine Dreiecke; bis zum Ende der Datei wurden { $count } gelesen.
   *[other] { $announced } Dreiecke; gelesen wurden die { $count }, die die Datei hat.
}
oddity-fourth-numbers = { $count ->
    [one] { $count } Ecke hat
   *[other] { $count } Ecken haben
} eine vierte Zahl, zuerst bei { $first }; sie blieb unbeachtet.
oddity-other-cells = Punkte, Linien und Körper gehören zu keiner Fläche und wurden übergangen: { $count }, zuerst bei { $first }.
oddity-solid-cells = Die Datei hat Zellen mit Rauminhalt ({ $count }) und keine Flächen: Gelesen wurde die Oberfläche um sie.
oddity-seams-joined = { $count ->
    [one] { $count } Ecke am Ort einer anderen wurde
   *[other] { $count } Ecken am Ort einer anderen wurden
} mit ihr vereinigt: Das Format teilt Ecken an Nähten.
oddity-left-out = Weggelassen: { $what }.
extra-colours = Farben
extra-texture-coordinates = Texturkoordinaten
extra-materials = Materialien
extra-groups = Gruppen
extra-data = Werte an Ecken und Zellen

## Was einer geschriebenen Datei fehlt

loss-moved = { $format } hat Koordinaten einfacher Genauigkeit: Das Netz wurde an den Ursprung verschoben, um ({ NUMBER($x, digits: 17) }, { NUMBER($y, digits: 17) }, { NUMBER($z, digits: 17) }). PLY, OBJ und OFF behalten seinen Ort.
loss-polygons = { $format } kennt nur Dreiecke: Vielecke wurden zerlegt ({ $count }). PLY, OBJ und OFF behalten sie.
loss-joined = { $format } kennt Ecken an ihrem Ort: Die am Ort einer anderen werden beim Lesen mit ihr vereint ({ $count }). PLY, OBJ, OFF und GLB halten sie auseinander.
loss-colours = { $format } hat keinen Platz für Farben der Ecken: Sie wurden weggelassen. PLY, OBJ, OFF und GLB behalten sie.
loss-colours-lost = Die Eckenfarben der Datei sind verloren: Der Löser wurde auf Ecken neu gestartet, die beim Neuvernetzen entstanden waren. Vom Anfang an abgespielt, sind sie wieder da.

## Netze, die sich nicht schreiben lassen

write-no-faces = es gibt keine Facetten zu schreiben
    .hint = Laden Sie zuerst ein Netz.
write-index-out-of-range = Facette { $face } nennt Ecke { $index } von { $vertices }
    .hint = Das ist ein Fehler des Programms; bitte melden Sie ihn.
write-non-finite-vertex = Ecke { $vertex } lässt sich nicht als Zahl schreiben
    .hint = Gehen Sie zurück zu einem Zustand mit endlichen Lagen.
write-beyond-single = Ecke { $vertex } lässt sich nicht als 32-Bit-Gleitkommazahl schreiben
    .hint = Verkleinern Sie das Netz, oder nehmen Sie OBJ, OFF oder PLY: Sie behalten doppelte Genauigkeit.
write-below-single = Das Netz ist zu klein für 32-Bit-Gleitkommazahlen: Sie können seine Ecken nicht auseinanderhalten.
    .hint = Vergrößern Sie das Netz, oder nehmen Sie OBJ, OFF oder PLY: Sie behalten doppelte Genauigkeit.
write-normal-count = { $normals } Normalen für { $vertices } Ecken angegeben
    .hint = Das ist ein Fehler des Programms; bitte melden Sie ihn.
write-read-only = { $format } wird gelesen und nicht geschrieben
    .hint = Nehmen Sie PLY, OBJ, OFF, STL oder GLB.
write-too-large = das Netz ist zu groß für { $format }
    .hint = Nehmen Sie OBJ, OFF oder PLY.

## Archive, und mehrere Dateien auf einmal

unpack-no-mesh = Unter diesen Dateien ist kein Netz: { LIST($names, most: 6) }
    .hint = Öffnen Sie das Netz selbst oder ein Archiv, in dem es ist.
unpack-damaged = Das Archiv ist beschädigt oder bricht ab.
    .hint = Das Herunterladen oder Kopieren endete wohl zu früh; holen Sie die Datei noch einmal.
unpack-encrypted = Das Archiv ist verschlüsselt.
    .hint = Entpacken Sie es, und öffnen Sie, was darin ist.
unpack-unsupported = Das Archiv ist nach dem Verfahren { $method } komprimiert, das nicht gelesen wird.
    .hint = Entpacken Sie es, und öffnen Sie, was darin ist.
unpack-too-large = Entpackt wäre die Datei größer als { $megabytes } MB.
    .hint = Entpacken Sie sie, und öffnen Sie, was darin ist, wenn es ein Netz ist.
