# Was die Seite, der Worker und die Kommandozeile selbst sagen.

## Anzahlen

count-steps = { $count ->
    [one] { $count } Schritt
   *[other] { $count } Schritte
}
count-flips = { $count ->
    [one] { $count } Flip
   *[other] { $count } Flips
}
count-fills = { $count ->
    [one] das Füllen von { $count } Randkurve
   *[other] das Füllen von { $count } Randkurven
}
crossings = { $count ->
    [one] { $count } Dreieckspaar durchdringt sich.
   *[other] { $count } Dreieckspaare durchdringen sich.
}

## Die Statuszeile eines Laufs, der zu Ende ist

ended = { $status ->
    [converged] Konvergiert
    [stalled] Stecken geblieben
    [singular] Singulär
    [collapsed] Kollabiert
    [failed] Gescheitert
   *[stepLimit] Angehalten
} nach { $steps ->
    [one] { $steps } Schritt
   *[other] { $steps } Schritten
}

## Bearbeitungen

regularised = In { $passes ->
    [one] { $passes } Durchgang
   *[other] { $passes } Durchgängen
} regularisiert: kleinster Winkel { $angle }° → { $angleNow }°, Verzerrung { $distortion } → { $distortionNow }; keine Ecke ist weiter als { $distance } % der Größe von der vorigen Fläche entfernt. „Zurück“ nimmt es zurück.
filled = { $count ->
    [one] { $count } Randkurve
   *[other] { $count } Randkurven
} mit { $vertices ->
    [one] { $vertices } neuen Ecke
   *[other] { $vertices } neuen Ecken
} gefüllt. „Start“ glättet sie mit dem Fluss { $flow }. „Rückgängig“ nimmt die Füllung zurück.

## Wie ein Lauf endete

play-goes-on = { $reason }. „Start“ macht weiter.
end-untrusted = { $reason }. Nicht vertrauenswürdig: Das Netz ist zu grob oder zu zerknittert

## Füllen

fair-nothing = Es gibt keine neue Ecke und nichts, was { $flow } bewegen könnte.

## Der Worker und Folgen von Netzen

worker-internal = Im Löser ist ein Fehler aufgetreten: { $reason }
    .hint = Bitte melden Sie das, wenn möglich mit dem Netz.
worker-cancelled = Es wurde aufgegeben.
    .hint = Öffnen Sie es noch einmal, um von vorn zu beginnen.
sequence-too-large = { $meshes } Netze wären { NUMBER($gigabytes, digits: 2) } GB, mehr als 1 GB.
    .hint = Nehmen Sie weniger Schritte oder ein kleineres Format.

## A solver that was lost, or is silent

solver-lost-again = Der Löser brach jedes Mal ab, wenn die Fläche wiederhergestellt werden sollte.
    .hint = „Herunterladen“ sichert, was zu sehen ist. „Löser neu starten“ versucht es noch einmal; fehlt Speicher, so schließen Sie zuerst andere Tabs.
lost-with-solver = { $what ->
    [steps] Seine gespeicherten Schritte sind verloren; der Verlauf beginnt neu.
    [edits] Frühere Änderungen lassen sich nicht mehr rückgängig machen.
   *[both] Seine gespeicherten Schritte sind verloren, der Verlauf beginnt neu, und frühere Änderungen lassen sich nicht mehr rückgängig machen.
}
saved-own-copy = Der Löser ist jetzt nicht zu fragen: Das Netz wurde als PLY gesichert, in Dreiecken, aus dem, was die Seite selbst hat.
no-mesh-yet = Es gibt noch kein Netz.

## Archive und mehrere Dateien zugleich

unpack-others = Von mehreren Netzen wurde das größte geöffnet, { $name }; beiseite blieben: { LIST($others, most: 6) }
