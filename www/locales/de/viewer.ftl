# The viewer: src/viewer/error.rs.

viewer-no-web-gpu = dieser Browser hat kein WebGPU, oder die Seite kommt nicht über eine sichere Verbindung
    .hint = Nehmen Sie ein aktuelles Chrome, Edge, Firefox oder Safari, über https oder auf localhost.
viewer-no-adapter = { $api } bietet keine Grafikkarte an
    .hint = Schalten Sie in den Einstellungen des Browsers die Hardwarebeschleunigung ein, oder erneuern Sie den Grafiktreiber.
viewer-no-device = die Grafikkarte gibt kein Gerät her: { $reason }
    .hint = Schalten Sie in den Einstellungen des Browsers die Hardwarebeschleunigung ein, oder erneuern Sie den Grafiktreiber.
viewer-no-canvas = die Zeichenfläche gibt keinen { $api }-Kontext her: { $reason }
    .hint = Laden Sie die Seite neu.
viewer-gpu-lost = die Grafikeinheit ist verloren gegangen: { $reason }
    .hint = Laden Sie die Seite neu. Ihre Fläche ist sicher: Laden Sie sie vorher herunter, wenn Sie sie verändert haben.
viewer-wrong-length = { $array }: { $found } Einträge, das Netz verlangt { $expected }
    .hint = Das ist ein Fehler des Programms; bitte melden Sie ihn.
viewer-wrong-time = die Zeit eines Schritts liegt nicht nach der des vorigen
    .hint = Das ist ein Fehler des Programms; bitte melden Sie ihn.
viewer-out-of-range = { $array } nennt Element { $index } von { $count }
    .hint = Das ist ein Fehler des Programms; bitte melden Sie ihn.
viewer-too-large = { $vertices } Ecken sind mehr als die { $limit }, die diese Grafikeinheit zeichnen kann
    .hint = Vereinfachen Sie das Netz zuerst.
