## Recipes that cannot be read or followed

recipe-not-json = Das Rezept ist kein JSON: Zeile { $line } ist nicht lesbar.
    .hint = Rezepte entstehen mit „Speichern als: Rezept“.
recipe-too-long = Das Rezept hat { $bytes } Bytes, mehr als die { $most }, die gelesen werden.
    .hint = Gehen Sie in weniger Schritten vor und speichern Sie das Netz dazwischen.
recipe-malformed = „{ $key }“ im Rezept muss so sein: { $must }.
    .hint = Rezepte entstehen mit „Speichern als: Rezept“.
recipe-option = { $error }
recipe-old-option = { $error } (das Rezept schrieb Version { $version }; dies ist Version { $present })
    .hint = Öffnen Sie es mit Version { $version }, oder berichtigen Sie es von Hand.
recipe-too-many-selected = Die Auswahlen enthalten zusammen { $count } Ecken, mehr als die { $most }, die gelesen werden.
    .hint = Gehen Sie in weniger Schritten vor und speichern Sie das Netz dazwischen.
recipe-too-many-flows = Der Fluss wechselt { $count } Mal auf einem Netz mit { $vertices } Ecken: Das ist zu viel.
    .hint = Gehen Sie in weniger Schritten vor und speichern Sie das Netz dazwischen.
recipe-mesh-missing = Das Rezept braucht das Netz { $name }.
    .hint = Öffnen Sie es zuerst.
recipe-another-mesh = Die Datei ist nicht das Netz { $name }: Ihr SHA-256 beginnt mit { $found }, nicht mit { $asked }.
    .hint = Das Rezept gilt nur für genau diese Datei, bis aufs letzte Byte.
recipe-ends-early = Der Fluss endet bei Schritt { $step } von { $goal }: { $reason }.
    .hint = Nehmen Sie weniger Schritte.
recipe-no-flow = Es ist noch kein Fluss gewählt.
    .hint = Wählen Sie zuerst einen.
recipe-origin-unknown = Von dieser Fläche lässt sich kein Rezept machen: Woher ihr Netz kam, ist nicht mehr bekannt.
    .hint = Öffnen Sie das Netz oder wählen Sie das Beispiel noch einmal; was von da an geschieht, lässt sich festhalten.
recipe-not-replaying = Es wird kein Rezept ausgeführt.
    .hint = Öffnen Sie zuerst eines.

must-be-version = die Version, als Text
must-be-object = ein Objekt
must-be-list = eine Liste
must-be-count = eine ganze Zahl von 0 bis { $most }
must-be-number = eine Zahl
must-be-number-or-null = eine Zahl oder null
must-be-digest = ein SHA-256, 64 Ziffern von 0 bis f
must-be-shape = der Name einer Form
must-be-sample = der Name eines Beispiels
must-be-file = der Name einer Datei
must-be-numbers = ein Objekt aus Zahlen
must-be-options = ein Objekt aus Optionen
must-be-action = {"{"} steps {"}"}, {"{"} regularise {"}"}, {"{"} flow {"}"} oder „anew“
must-be-edit = „adopt“, {"{"} fill {"}"}, {"{"} flip {"}"}, {"{"} subdivide {"}"}, {"{"} remesh {"}"} oder {"{"} invert: [x, y, z] {"}"}, mit Optionen, die es gibt
must-be-regularisation = Optionen einer Regularisierung
must-be-steps = eine Liste, deren Schritte zusammen { $total } sind, wie „steps“ sagt

## Links that cannot be read

link-too-long = Der Link hat { $bytes } Bytes, mehr als die { $most }, die gelesen werden.
    .hint = Kopieren Sie einen Link von der Seite, um zu sehen, wie seine Wörter geschrieben werden.
link-twice = Der Link hat „{ $word }“ mehr als einmal.
    .hint = Kopieren Sie einen Link von der Seite, um zu sehen, wie seine Wörter geschrieben werden.
link-bad-word = „{ $word }“ kann nicht „{ $value }“ sein.
    .hint = Erlaubt ist: { $allowed }.
link-figure = { $error }
link-option = { $error }
link-recipe = { $reason }

link-value-sample = die Kennung eines Beispiels
link-value-digest = die ersten 16 Ziffern eines SHA-256, oder mehr davon
link-value-step = eine ganze Zahl mit höchstens sieben Ziffern
link-value-percent = eine ganze Zahl von 0 bis 100
link-value-camera = die Zahlen einer Kamera, mit Kommas dazwischen
link-value-one-of = eines von { $names }
link-value-energy = eine Zahl
link-value-version = eine Version
link-value-edits = Bearbeitungen, wie ein Link sie schreibt
link-value-path = ein Weg, wie ein Link ihn schreibt, bis Schritt { $step }
link-value-panes = höchstens drei Teilfenster, von Flüssen, die Ecken bewegen
link-value-pane = der Buchstabe eines Teilfensters
