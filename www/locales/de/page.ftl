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
boundary-loops = { $count ->
    [one] { $count } Randkurve.
   *[other] { $count } Randkurven.
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
} gefüllt. „Start“ lässt den Fluss sie glätten; „Rückgängig“ nimmt die Füllung zurück.
