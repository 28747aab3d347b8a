# Optionen eines Flusses, wie Formulare, Menüs und `umbilic flow --help` sie nennen.

option-flow = Fluss
option-flow-help = welcher Fluss

option-scheme = Schema
    .auto = Empfohlen
    .paper = Wie in der Arbeit
option-scheme-help = auto wählt die Schrittweite; paper behält das Verfahren der Arbeit und ein festes --dt

option-boundary = Rand
    .clamped = Eingespannt (Tangente)
    .fixed = Fest (nur die Lage)
    .free = Frei
option-boundary-help = was am Rand eines offenen Netzes gilt; auto ist das Übliche des Flusses

option-free = Freie Ecken
option-free-help = nur diese Ecken bewegen sich
option-fixed = Festgehaltene Ecken
option-fixed-help = diese Ecken bewegen sich nicht
option-prefill = Glatter erster Ansatz
option-prefill-help = legt die freien Ecken vor dem ersten Schritt glatt aus

option-p = Exponent p
option-p-help = der Exponent von ∫|H|^p dA
option-keep = Beibehalten
    .area = Flächeninhalt
    .volume = Volumen
option-keep-help = was beibehalten wird
option-reducedVolume = Reduziertes Volumen
option-reducedVolume-help = führt das Volumen auf diesen Anteil an dem der Kugel gleichen Flächeninhalts; Flächeninhalt und Volumen werden beibehalten
option-spontaneousCurvature = Spontane H₀ · L
option-spontaneousCurvature-help = mit p = 2, H₀ in ∫(H − H₀)² dA, mal L = √(A/4π)
option-tension = Spannung σ · L²
option-tension-help = mit p = 2, σ in ∫|Y|² dA + σA, mal L²
option-pressure = Druck P · L³
option-pressure-help = mit p = 2, P in ∫|Y|² dA − PV, mal L³

option-epsilon = Winkelglättung ε
option-epsilon-help = Glättung der Winkel
option-sharpen = Am Ende schärfen (ε → 0)
option-sharpen-help = lässt ε am Ende gegen 0 gehen

option-criterion = Kriterium
    .area = Flächeninhalt
    .willmore = Willmore-Energie
    .localised = Lokalisierte Willmore-Energie
option-criterion-help = was klein werden soll
option-guardFolds = Kein Flip darf eine Facette umklappen
option-guardFolds-help = kein Flip klappt eine Facette um; das verbietet auch das Zurückklappen

option-goal = Ziel
    .relax = Zur Ruhe kommen
    .smooth = Etwas glätten
option-goal-help = relax geht zu einem Minimum; smooth entfernt ein festes Maß an Einzelheiten
option-detail = Einzelheiten unter L glätten
option-detail-help = entfernt Einzelheiten unter so vielen mittleren Kantenlängen
option-smoothSteps = Verteilt auf (Schritte)
option-smoothSteps-help = in so vielen Schritten

option-tau = Zeitschritt τ
    .absent = automatisch
option-tau-help = Schrittweite ohne Einheit: dt/h² beim Fluss der Kreiswinkel, h die mittlere Kantenlänge; sonst dt/L^k, k die Ordnung, L die Größe dessen, was sich bewegt
option-dt = Zeitschritt dt
option-dt-help = Schrittweite in der Einheit des Netzes: Länge², bei p-Willmore Länge^(p+2), bei einem Fluss der Ordnung k Länge^k
option-tauGrowth = Wachstum von τ
option-tauGrowth-help = Faktor der Schrittweite nach jedem Schritt
option-tauMax = Größtes τ
option-tauMax-help = größte Schrittweite ohne Einheit

option-compare = Daneben
    .none = Nichts
    .start = Der Anfang
    .criteria = Die anderen Kriterien
    .flows = Die anderen Flüsse
option-compare-help = was nebeneinander steht
option-subdivide = Unterteilt zeigen
option-subdivide-help = so viele Male, nach Loop, nur im Bild
option-flipsPerStep = Flips je Schritt
    .absent = alle
option-flipsPerStep-help = wie viele Flips ein Schritt sind

option-integrator = Integrator
    .semi-implicit = Semi-implizit
    .forward-euler = Explizites Euler-Verfahren
    .backward-euler = Implizites Euler-Verfahren (Newton)
    .l-bfgs = L-BFGS
option-integrator-help = wie ein Schritt gemacht wird
option-mass = Masse
    .auto = Automatisch
    .uniform = Gleichmäßig
    .area = Inhalt je Ecke
option-mass-help = Gewicht einer Ecke
option-remesh = Neu vernetzen
    .adaptive = Nach Krümmung
    .isotropic = Gleichmäßig
    .off = Aus
option-remesh-help = neue Dreiecke, wo ein geschlossenes Netz schlecht geworden ist, statt zu regularisieren
option-regularise = Regularisieren
    .off = Nie
    .linear = Nach jedem Schritt, linear
    .nonlinear = Nach jedem Schritt
option-regularise-help = konforme Regularisierung nach jedem Schritt
option-regulariseEpsilon = Regularisierung ε
option-regulariseEpsilon-help = 0.001 ist der Fläche treu, 0.1 greift stark ein
option-perturbation = Anfang stören um
option-perturbation-help = verschiebt den Anfang entlang seiner Normalen um bis zu so viele mittlere Kantenlängen
option-rungs = Zuvor Schritte der Oberflächendiffusion
option-rungs-help = zuvor so viele Schritte der Oberflächendiffusion; auto sind so viele, wie ein rauer Anfang braucht

option-maxSteps = Schrittgrenze
    .absent = keine
option-maxSteps-help = höchstens so viele Schritte, wie lange sie auch dauern
option-maxSeconds = Halt nach (Sekunden)
    .absent = nie
option-maxSeconds-help = höchstens so viele Sekunden Rechenzeit, wo keine Zahl von Schritten gesetzt ist

# Neben dem, was gewählt werden kann.
option-nothing = Nichts
option-no = Nein
option-yes = Ja
