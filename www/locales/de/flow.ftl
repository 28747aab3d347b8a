# Flüsse: src/flow.

## Warum ein Fluss nicht beginnen oder weitergehen kann

flow-not-triangular = Facette { FACE($face) } hat { $corners } Ecken; dieser Fluss arbeitet auf Dreiecken
    .hint = Triangulieren Sie das Netz zuerst.
flow-zero-length-edge = die Kante zwischen den Ecken { VERTEX($a, bare: 1) } und { VERTEX($b) } hat keine Länge{ $others ->
    [0] {""}
    [one] ; eine weitere Kante ist ebenso
   *[other] ; { $others } weitere Kanten sind ebenso
}
    .hint = Eine Reparatur zieht die Kante zusammen.
flow-nothing-free = keine Ecke kann sich bewegen
    .hint = Wählen Sie eine größere Auswahl. Ein eingespannter Rand hält auch die Ecken fest, die eine Kante von ihm entfernt sind: Ein fester oder freier tut das nicht, oder ein feineres Netz hilft.
flow-selection-out-of-range = die Auswahl nennt Ecke { VERTEX($vertex) }, es gibt aber nur { $vertices } Ecken
    .hint = Ecken haben die Nummern, die die Datei ihnen gibt.
flow-option = { $error }
flow-not-closed = die Fläche hat { $loops ->
    [one] { $loops } Randkurve
   *[other] { $loops } Randkurven
}; dieser Fluss ist für geschlossene Flächen
    .hint = Füllen Sie ihre Löcher, oder wählen Sie den Willmore-Fluss der Kreiswinkel, der Ränder zulässt.
flow-not-oriented = die Fläche ist einseitig; dieser Fluss ist für orientierbare Flächen
    .hint = Wählen Sie den Willmore-Fluss der Kreiswinkel, der keine Orientierung braucht.
flow-mixed-faces = das Netz mischt Facetten verschiedener Eckenzahl
    .hint = Triangulieren Sie das Netz zuerst.
flow-too-large = das Netz hat { $vertices } Ecken; das Schema der Arbeit nimmt { $limit }
    .hint = Wählen Sie das empfohlene Schema, das gegen denselben Fluss strebt, oder ein gröberes Netz.
flow-unfit = bei Ecke { VERTEX($vertex) } lässt sich die Fläche nicht anpassen
    .hint = Sie hat zu wenige Nachbarn, einige fallen zusammen, oder Facetten um sie sind zusammengefallen oder umgeklappt: Unterteilen Sie das Netz, reparieren Sie es dort, oder halten Sie die Ecken darum fest.
flow-inaccurate = das lineare Gleichungssystem wurde nur auf ein Residuum von { NUMBER($residual, digits: 2) } gelöst
    .hint = Wählen Sie eine kleinere Schrittweite, ein gröberes Netz oder einen Fluss niedrigerer Ordnung.
flow-non-finite-energy = die Energie ist bei Schritt { $step } keine endliche Zahl
    .hint = Gehen Sie einen Schritt zurück, wählen Sie eine kleinere Schrittweite oder das empfohlene Schema, und suchen Sie nach einem umgeklappten oder zusammengefallenen Dreieck.
flow-linear = das lineare Gleichungssystem ließ sich nicht lösen: { $reason }

## Warnungen eines Schritts

warning-near-bound = ∫H² liegt unter dem jeder glatten Fläche mit diesen Henkeln: Das Netz löst die Fläche nicht mehr auf.
warning-growth = Der Flächeninhalt ist auf ein Mehrfaches gewachsen: Vielleicht bildet sich eine Blase, rund und deshalb billig. Glätten Sie einen rauen Anfang zuerst ein wenig.
warning-balloon = Die Hälfte des Flächeninhalts liegt in wenigen großen Facetten: Ein Teil der Fläche bläht sich auf, was diese Energie nicht stört. Der p-Willmore-Fluss, der Flächeninhalt und Volumen beibehält, lässt das nicht zu.
warning-reading-rose = W stieg in diesem Schritt von { NUMBER($before, digits: 5) } auf { NUMBER($after, digits: 5) }, obwohl die geglättete Energie fiel, die der Fluss senkt: Viele Winkel waren nahe null.
warning-roughened = ∫H² stieg von { NUMBER($before, digits: 4) } auf { NUMBER($after, digits: 4) }, während W fiel: Die Fläche wurde rauer. Wo Kanten schräg zu den Krümmungslinien liegen, sagt W mehr über das Netz als über die Fläche. Vernetzen Sie sie zuerst neu, oder glätten Sie durch Oberflächendiffusion.
warning-coarse = Bei Ecke { VERTEX($vertex) } sind die Kanten zu lang für die Krümmung: Nehmen Sie ein feineres Netz.
warning-nearly-singular = Bei Ecke { VERTEX($vertex) } wird die Fläche gleich singulär, wie ein Hals, der sich abschnürt: Nehmen Sie ein feineres Netz.
warning-large-face = Die größte Facette ist auf das { $times }-Fache des Mittels gewachsen: Ein Teil der Fläche bläht sich auf, und die gezeigte Energie ist zu klein. Ein feineres Netz hilft.
warning-slivers = Das Netz entartet: Sein kleinster Winkel ist { NUMBER($degrees, digits: 2) }°, { NUMBER($before, digits: 2) }°, als diese Dreiecke neu waren. { $advice }.
warning-folded-faces = In diesem Schritt umgeklappt: { $count ->
    [one] { $count } Facette
   *[other] { $count } Facetten
}.
warning-far-moves = Das empfohlene Schema begrenzt, wie weit sich Ecken bewegen.
warning-iterative-mesh = Das Netz ist zu groß, um seine Matrizen im Speicher zu zerlegen: Sie werden iterativ gelöst, und Schritte dauern länger.
warning-iterative-patch = Der Flicken ist zu groß, um seine Matrix im Speicher zu zerlegen: Sie wird iterativ gelöst, und Schritte dauern länger.
warning-inaccurate = Das lineare Gleichungssystem wurde nur auf ein Residuum von { NUMBER($residual, digits: 2) } gelöst.
warning-margin = { $rings ->
    [2] Weniger als zwei Ringe festgehaltener Ecken liegen zwischen dem Rand des freien Flickens und dem des Netzes: Dort wird die Fläche von einer Seite angepasst, und nur die Lage ist vorgegeben, nicht die Krümmung.
   *[other] Weniger als ein Ring festgehaltener Ecken liegt zwischen dem Rand des freien Flickens und dem des Netzes: Dort wird die Fläche von einer Seite angepasst, und nur die Lage ist vorgegeben, nicht die Tangentialebene.
}
warning-disagreement = Zwei Werte von ∫H², mit konzentrierter und mit konsistenter Masse, weichen um { NUMBER($percent, digits: 2) } % voneinander ab: Das Netz löst seine Krümmung nicht gut auf.
warning-untrusted = Nicht vertrauenswürdig: Das Netz ist zu grob oder zu zerknittert, als dass seine Messwerte viel bedeuten.
warning-branch = Das Volumen ist, wo es hin sollte. Die Form ist { $shape ->
    [round] rund
    [prolate] gestreckt
    [oblate] abgeplattet
   *[triaxial] dreiachsig
}: Ihre Hauptlängen sind 1 : { $middle } : { $shortest }. Andere Formen in Ruhe mit diesem Flächeninhalt und Volumen haben vielleicht weniger Energie; durch eine Störung am Anfang verlässt eine symmetrische Form einen instabilen Zweig.
warning-halved-step = Der Schritt war zu groß, I/dt + K nicht positiv definit, und wurde { $times }-mal halbiert.
warning-newton-failed = Das Newton-Verfahren ist in diesem Schritt nicht konvergiert.
warning-near-sphere = Nahe einer Sphäre übernehmen wieder semi-implizite Schritte.
warning-away-from-sphere = Fern von einer Sphäre werden die Winkel wieder geglättet.
warning-little-gain = Schritte bringen wenig: L-BFGS übernimmt.
warning-no-gain = Schritte bringen nichts: L-BFGS übernimmt.
warning-exact-halt = Genaue Schritte kommen nicht weiter: Die Winkel werden wieder geglättet.
warning-another-round = W fällt noch: eine weitere Runde L-BFGS.
warning-open-boundary = Der Inhalt ist um { $percent } % gewachsen: Was ein Fluss dieser Ordnung an einem Rand tut, der nur an seinem Ort gehalten wird, ist nicht bestimmt. Ein eingespannter Rand hält auch seine Tangentialebenen.
warning-rough-start = Der Anfang ist zu rau für den Fluss sechster Ordnung, der ihn um { NUMBER($edges, digits: 2) } Kantenlängen bewegen würde: Bis zu { $steps } Schritte der Oberflächendiffusion gehen voraus.
warning-back-to-start = Keine Ruhe in Sicht: zurück zum Anfang, bis zu { $steps } Schritte der Oberflächendiffusion gehen voraus.
warning-better-before = Eine Fläche unterwegs hatte weniger Energie als die letzte: Sie wird eingesetzt.

## Was hilft, in einem halben Satz

advice-finer-mesh = Ein feineres Netz hilft
advice-better-mesh = Ein besseres Netz hilft, wie konforme Regularisierung es macht
advice-regular-or-finer = Konforme Regularisierung oder ein feineres Netz hilft
advice-keep-volume = Wo sie dünn wird, wird die Fläche singulär, und das Volumen beizubehalten verhindert das
advice-smooth-first = Glätten Sie zuerst mit p = 2, oder nehmen Sie ein feineres Netz
advice-p-willmore-zero = Der p-Willmore-Fluss mit p = 0 behält ein besseres Netz
advice-regular-or-p-willmore = Konforme Regularisierung oder der p-Willmore-Fluss hilft
advice-first-guess = Ein glatter erster Ansatz, ein feineres Netz oder ein Fluss niedrigerer Ordnung hilft

## Warum ein versuchter Schritt abgelehnt wurde: nach „weil“

cause-rise = die Energie steigen würde
cause-reading-jump = die Energie, wie sie gedruckt ist, hochspringen würde
cause-bound = die Energie unter der jeder glatten Fläche dieser Topologie läge
cause-unfit = sich Krümmungen nicht mehr anpassen ließen
cause-fold = Facetten umklappen würden
cause-too-far = eine Ecke sich um mehr als eine halbe Kante bewegen würde
cause-turn = eine Facette sich um mehr als 60° drehen würde
cause-sliver = eine Facette zum Splitter würde
cause-constraints = sich die Nebenbedingungen nicht zugleich erfüllen lassen
cause-not-finite = die Energie nicht endlich ist
cause-newton = das Newton-Verfahren nicht konvergiert oder eine Facette umklappen würde

## Warum ein Lauf zu Ende ist, nach seinem Status

clock-own = nach dem Gesetz dieses Flusses
clock-mean-curvature = mit der Normalgeschwindigkeit −H
clock-area-gradient = mit der Normalgeschwindigkeit −2H, die halb so lange braucht wie −H
reason-at-rest = die Fläche ist in Ruhe
reason-still = keine Ecke bewegt sich mehr
reason-zero-energy = die Energie ist bis auf Rundung null
reason-smoothed = wie verlangt in { $steps ->
    [one] { $steps } Schritt
   *[other] { $steps } Schritten
} geglättet
reason-step-limit = die Grenze von { $steps ->
    [one] { $steps } Schritt
   *[other] { $steps } Schritten
} ist erreicht
reason-time-limit = die { $seconds } Sekunden Rechenzeit sind verbraucht, und die Fläche ist nicht in Ruhe
reason-large-face = Facette { FACE($face) } ist { $times }-mal so groß wie das Mittel, und das Netz löst die Fläche nicht mehr auf. Ein feineres Netz hilft, oder Flächeninhalt und Volumen unter dem p-Willmore-Fluss beizubehalten
reason-refused = jeder versuchte Schritt wurde abgelehnt, der letzte, weil { $cause }. { $advice }
reason-flat-face = { $count ->
    [one] Facette { FACE($face) } hat
   *[other] { $count } Facetten, zuerst Facette { FACE($face) }, haben
} keinen Flächeninhalt, und von dort führt kein Schritt weiter. Eine Reparatur nimmt solche Facetten heraus
reason-creeping = nur immer kleinere Schritte senken die Energie, die nicht in Ruhe ist. { $advice }
reason-grows-on = die Fläche ist auf das { $times }-fache ihres Inhalts gewachsen und wächst immer weiter: Ruhe gibt es nur, wenn Flächeninhalt oder Volumen beibehalten wird
reason-rises = Schritte dieser Größe führen zu mehr Energie, dem { NUMBER($times, digits: 2) }-fachen dessen, was unterwegs war. Eine kleinere Schrittweite hilft, oder das Verfahren, das sie selbst wählt
reason-rises-on = die Energie ist auf das { NUMBER($times, digits: 2) }-fache dessen gestiegen, was sie unterwegs war. { $advice }
reason-worse-rest = der Fluss endet mit mehr Energie, als er unterwegs hatte. { $advice }
reason-below-bound = jeder weitere Schritt hat weniger Energie als jede glatte Fläche dieser Topologie: Diese Dreiecke zeigen keine mehr. Ein feineres oder besseres Netz hilft
reason-unresolved = die Krümmungen dieser Dreiecke haben zusammen weniger Energie als jede glatte Fläche dieser Topologie, sodass sich kein Schritt an ihnen messen lässt. Die Fläche ist, wie sie war, und ein Netz aus gleichmäßigen Dreiecken hilft oder der p-Willmore-Fluss
reason-vanishes = ungefähr zur Zeit { NUMBER($time, digits: 2) } ({ $clock }) schrumpft die Fläche auf einen Punkt bei ({ $place }). Das Volumen beizubehalten verhindert das
reason-part-vanishes = spätestens zur Zeit { NUMBER($time, digits: 2) } ({ $clock }) ist ein Teil der Fläche zu einem Punkt nahe ({ $place }) geschrumpft
reason-vanishes-to-curve = ungefähr zur Zeit { NUMBER($time, digits: 2) } ({ $clock }) schrumpft die Fläche auf eine Kurve. Das Volumen beizubehalten verhindert das
reason-pinched-neck = ungefähr zur Zeit { NUMBER($time, digits: 2) } ({ $clock }) schnürt sich bei Ecke { VERTEX($vertex) }, nahe ({ $place }), ein Hals ab. Darüber hinaus hat der Fluss keine Lösung. { $advice }
reason-sharp-tip = die Fläche ist bei Ecke { VERTEX($vertex) }, nahe ({ $place }), stärker gekrümmt, als ihre Dreiecke zeigen. { $advice }
reason-no-flips = kein Flip senkt noch { $criterion ->
    [area] den Flächeninhalt
    [willmore] die Willmore-Energie
    [localised] die lokalisierte Willmore-Energie
   *[all] eines der drei Kriterien
}
