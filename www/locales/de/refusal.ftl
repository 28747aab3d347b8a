## Eine Option, die es nicht gibt, oder ein Wert, den sie nicht haben kann

option-error-unknown-option = es gibt keine Option `{ $name }`
    .hint = { $near ->
        [none] --help nennt die Optionen der Befehlszeile, ein kopierter Link die der Seite.
       *[other] Meinten Sie `{ $near }` (--{ $flag })?
    }
option-error-bad-option = `{ $name }` kann nicht `{ $value }` sein
    .hint = Erlaubt ist: { $allowed }.
option-error-unread-option = `{ $name }` ändert hier nichts: es gehört zu { $flows }{ $scheme ->
        [any] { $goal ->
            [any] {""}
           *[other] {" mit dem Ziel "}{ $goal }
        }
       *[other] {" mit dem Schema "}{ $scheme }
    }
    .hint = Lassen Sie es weg, oder wählen Sie, was es liest.
option-error-missing-option = `{ $name }` fehlt
    .hint = Erlaubt ist: { $allowed }.
option-error-lone-option = `{ $name }` gilt nur, wenn `{ $other }` `{ $value }` ist
    .hint = Lassen Sie es weg, oder wählen Sie, was es liest.
option-error-conflicting-options = `{ $first }` und `{ $second }` können nicht beide angegeben werden
    .hint = Beide sagen dasselbe auf ihre Weise.

## Was der Wert einer Option sein darf

allowed-range = eine Zahl von { $low } bis { $high }
allowed-zero-or-range = 0 oder eine Zahl von { $low } bis { $high }
allowed-above = eine Zahl über { $low }, höchstens { $high }
allowed-whole-range = eine ganze Zahl von { $low } bis { $high }
allowed-one-of = eines von { $names }
allowed-any-of = none oder beliebige von { $names }
allowed-switch = true oder false
allowed-several-of = beliebig viele davon, mit Kommas dazwischen: { $allowed }
allowed-vertices = eine Liste von Eckennummern ab 0
allowed-word-or = { $word } oder { $allowed }
allowed-moving-flow = ein Fluss, der Ecken bewegt
allowed-curvature-flow = ein Fluss nach der mittleren Krümmung oder ihren Ableitungen
allowed-with-area-and-volume = nur dort, wo Flächeninhalt und Volumen beibehalten werden
allowed-helfrich-two = nur 2 mit spontaner Krümmung, Spannung oder Druck
allowed-zero-on-quadrilaterals = 0 auf Vierecken; triangulieren Sie das Netz für andere Werte
allowed-zero-in-paper = nur 0 im Schema der Arbeit
