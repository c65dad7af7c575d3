"""The page's own words, in the languages of the instructions; what patterns have in common stands in their terms."""

from __future__ import annotations

from typing import Final

_EN: Final = {
    "pattern": "Amigurumi crochet pattern", "by": "by {name}", "before": "Before you begin", "width": "width",
    "height": "height", "depth": "depth", "around": "around the widest round", "hook": "hook", "stuffing": "Stuffing",
    "notions": "Notions", "needle": "tapestry needle, to sew the parts together",
    "ends": "tapestry needle, to weave in the ends",
    "marker": "stitch marker, for the first stitch of each round", "scissors": "scissors",
    "eyes": "{n} safety eyes, {size} mm", "eye": "1 safety eye, {size} mm", "embroidery": "{cm} cm, to embroider",
    "felt": "felt, {n} × {w} × {h} mm", "hair": "{n} strands of {cm} cm, for hair",
    "fill": "polyester fibrefill, about {grams} g ({litres} l)", "skein": "1 skein of {grams} g",
    "skeins": "{n} skeins of {grams} g", "weight": "{name} weight ({number})",
    "typical": "Grams are those of a typical {name} yarn, {metres} m in 100 g; a tenth is to spare.",
    "swatch": "Flat: {stitches} sc and {rows} rows in 10 cm (4 in).",
    "circle": "Circle: five rounds (6, 12, 18, 24, 30) measure {cm} cm ({inch} in) across.",
    "tight": "Work tightly enough that no stuffing shows. With another gauge the size changes in proportion.",
    "expected": "No gauge was given: this is what such yarn and hook lead one to expect.",
    "stuffed": "Measured stuffed.", "stuffed, sitting": "Measured stuffed and sitting.",
    "stuffed, standing": "Measured stuffed and standing.", "laid flat": "Measured laid flat.",
    "as it lies": "Measured as it lies.", "continued": "continued", "charts": "Stitch diagrams",
    "chart note": "Read from the middle outwards, counter-clockwise; rows from the bottom up. Each patch is a stitch in its yarn's colour.",
    "step": "Step {n}", "new": "What is new is in full colour.", "care": "Care",
    "care text": "Wash by hand in cool water with a little mild soap, press out in a towel, pull into shape and dry lying flat. For a child under three, embroider the eyes instead of using plastic ones, and sew every part on twice.",
    "made": "Size, yarn and gauge were computed from the stitches; your own hand may differ.",
    "notes": "How to read it",
    "notes text": "A number before a stitch says how many to make, each in a stitch of its own. Square brackets are worked as often as is said after them. The number in round brackets is the count of stitches at the end of the round. Tick the box when a round is done.",
    "front": "from the front", "right": "from the right", "back": "from the back", "a eye": "Eyes", "a felt": "Felt", "a embroidery": "Embroidery", "a hair": "Hair",
}  # fmt: skip

_US: Final = {key: said.replace("colour", "color").replace("fibrefill", "fiberfill") for key, said in _EN.items()}

_UK: Final = {
    **_EN,
    "swatch": "Flat: {stitches} dc and {rows} rows in 10 cm (4 in).",
    "tight": "Work tightly enough that no stuffing shows. With another tension the size changes in proportion.",
    "expected": "No tension was given: this is what such yarn and hook lead one to expect.",
    "made": "Size, yarn and tension were computed from the stitches; your own hand may differ.",
}

_DE: Final = {
    "pattern": "Amigurumi-Häkelanleitung", "by": "von {name}", "before": "Bevor es losgeht", "width": "Breite",
    "height": "Höhe", "depth": "Tiefe", "around": "Umfang der weitesten Runde", "hook": "Häkelnadel",
    "stuffing": "Füllung", "notions": "Zubehör", "needle": "Wollnadel zum Zusammennähen",
    "ends": "Wollnadel zum Vernähen der Fäden", "marker": "Maschenmarkierer für die erste Masche jeder Runde",
    "scissors": "Schere", "eyes": "{n} Sicherheitsaugen, {size} mm", "eye": "1 Sicherheitsauge, {size} mm",
    "embroidery": "{cm} cm zum Sticken", "felt": "Filz, {n} × {w} × {h} mm",
    "hair": "{n} Fäden zu {cm} cm für die Haare", "fill": "Füllwatte, etwa {grams} g ({litres} l)",
    "skein": "1 Knäuel zu {grams} g", "skeins": "{n} Knäuel zu {grams} g", "weight": "Garnstärke {name} ({number})",
    "typical": "Die Gramm gelten für übliches Garn dieser Stärke ({name}), {metres} m auf 100 g; ein Zehntel ist Reserve.",
    "swatch": "Flach: {stitches} fM und {rows} Reihen auf 10 cm.",
    "circle": "Kreis: fünf Runden (6, 12, 18, 24, 30) messen {cm} cm.",
    "tight": "So fest häkeln, dass keine Füllung zu sehen ist. Mit anderer Maschenprobe ändert sich die Größe im selben Maß.",
    "expected": "Es ist keine Maschenprobe angegeben: So ist sie bei diesem Garn und dieser Nadel zu erwarten.",
    "stuffed": "Gefüllt gemessen.", "stuffed, sitting": "Gefüllt und sitzend gemessen.",
    "stuffed, standing": "Gefüllt und stehend gemessen.", "laid flat": "Flach liegend gemessen.",
    "as it lies": "Liegend gemessen.", "continued": "Fortsetzung", "charts": "Häkelschriften",
    "chart note": "Von der Mitte nach außen lesen, gegen den Uhrzeigersinn; Reihen von unten nach oben. Jedes Feld ist eine Masche in der Farbe ihres Garns.",
    "step": "Schritt {n}", "new": "Neues ist in voller Farbe gezeigt.", "care": "Pflege",
    "care text": "Von Hand in kühlem Wasser mit etwas milder Seife waschen, in einem Handtuch ausdrücken, in Form ziehen und liegend trocknen. Für Kinder unter drei Jahren die Augen sticken statt Kunststoffaugen zu nehmen und jedes Teil doppelt annähen.",
    "made": "Größe, Garn und Maschenprobe sind aus den Maschen errechnet; die eigene Hand kann abweichen.",
    "notes": "So liest man die Anleitung",
    "notes text": "Eine Zahl vor einer Masche sagt, wie viele zu häkeln sind, jede in eine eigene Masche. Eckige Klammern werden so oft gehäkelt, wie dahinter steht. Die Zahl in runden Klammern ist die Maschenzahl am Ende der Runde. Fertige Runden im Kästchen abhaken.",
    "front": "von vorn", "right": "von rechts", "back": "von hinten", "a eye": "Augen", "a felt": "Filz", "a embroidery": "Stickerei", "a hair": "Haare",
}  # fmt: skip

_FR: Final = {
    "pattern": "Patron de crochet amigurumi", "by": "par {name}", "before": "Avant de commencer", "width": "largeur",
    "height": "hauteur", "depth": "profondeur", "around": "tour du rang le plus large", "hook": "crochet",
    "stuffing": "Rembourrage", "notions": "Mercerie", "needle": "aiguille à laine, pour coudre les pièces",
    "ends": "aiguille à laine, pour rentrer les fils", "marker": "marqueur, pour la première maille de chaque tour",
    "scissors": "ciseaux", "eyes": "{n} yeux de sécurité, {size} mm", "eye": "1 œil de sécurité, {size} mm",
    "embroidery": "{cm} cm, pour broder", "felt": "feutrine, {n} × {w} × {h} mm",
    "hair": "{n} brins de {cm} cm, pour les cheveux", "fill": "ouate de polyester, environ {grams} g ({litres} l)",
    "skein": "1 pelote de {grams} g", "skeins": "{n} pelotes de {grams} g", "weight": "fil {name} ({number})",
    "typical": "Les grammes sont ceux d’un fil {name} courant, {metres} m pour 100 g ; un dixième est en réserve.",
    "swatch": "À plat : {stitches} ms et {rows} rangs sur 10 cm.",
    "circle": "Cercle : cinq tours (6, 12, 18, 24, 30) mesurent {cm} cm de diamètre.",
    "tight": "Crochetez assez serré pour que le rembourrage ne se voie pas. Avec un autre échantillon, la taille change d’autant.",
    "expected": "Aucun échantillon n’est donné : voici ce que ce fil et ce crochet laissent attendre.",
    "stuffed": "Mesuré rembourré.", "stuffed, sitting": "Mesuré rembourré et assis.",
    "stuffed, standing": "Mesuré rembourré et debout.", "laid flat": "Mesuré à plat.",
    "as it lies": "Mesuré tel quel.", "continued": "suite", "charts": "Diagrammes",
    "chart note": "Se lit du centre vers l’extérieur, dans le sens inverse des aiguilles d’une montre ; les rangs de bas en haut. Chaque case est une maille dans la couleur de son fil.",
    "step": "Étape {n}", "new": "Ce qui est nouveau est en pleine couleur.", "care": "Entretien",
    "care text": "Laver à la main à l’eau fraîche avec un peu de savon doux, presser dans une serviette, remettre en forme et sécher à plat. Pour un enfant de moins de trois ans, broder les yeux au lieu d’en poser en plastique, et coudre chaque pièce deux fois.",
    "made": "Taille, fil et échantillon sont calculés d’après les mailles ; votre main peut différer.",
    "notes": "Comment lire le patron",
    "notes text": "Un nombre devant une maille dit combien en faire, chacune dans sa propre maille. Les crochets se répètent autant de fois qu’il est dit après eux. Le nombre entre parenthèses est celui des mailles à la fin du tour. Cochez la case quand un tour est fait.",
    "front": "de face", "right": "de droite", "back": "de dos", "a eye": "Yeux", "a felt": "Feutrine", "a embroidery": "Broderie", "a hair": "Cheveux",
}  # fmt: skip

_ES: Final = {
    "pattern": "Patrón de amigurumi a ganchillo", "by": "de {name}", "before": "Antes de empezar", "width": "ancho",
    "height": "alto", "depth": "fondo", "around": "contorno de la vuelta más ancha", "hook": "ganchillo",
    "stuffing": "Relleno", "notions": "Otros", "needle": "aguja lanera, para coser las piezas",
    "ends": "aguja lanera, para esconder los hilos", "marker": "marcador, para el primer punto de cada vuelta",
    "scissors": "tijeras", "eyes": "{n} ojos de seguridad, {size} mm", "eye": "1 ojo de seguridad, {size} mm",
    "embroidery": "{cm} cm, para bordar", "felt": "fieltro, {n} × {w} × {h} mm",
    "hair": "{n} hebras de {cm} cm, para el pelo", "fill": "fibra de poliéster, unos {grams} g ({litres} l)",
    "skein": "1 ovillo de {grams} g", "skeins": "{n} ovillos de {grams} g", "weight": "hilo {name} ({number})",
    "typical": "Los gramos son los de un hilo {name} corriente, {metres} m en 100 g; sobra una décima parte.",
    "swatch": "En plano: {stitches} pb y {rows} hileras en 10 cm.",
    "circle": "Círculo: cinco vueltas (6, 12, 18, 24, 30) miden {cm} cm.",
    "tight": "Teje tan apretado que no se vea el relleno. Con otra muestra, el tamaño cambia en la misma medida.",
    "expected": "No se da una muestra: esto es lo que cabe esperar de este hilo y este ganchillo.",
    "stuffed": "Medido relleno.", "stuffed, sitting": "Medido relleno y sentado.",
    "stuffed, standing": "Medido relleno y de pie.", "laid flat": "Medido en plano.",
    "as it lies": "Medido tal como queda.", "continued": "continuación", "charts": "Diagramas",
    "chart note": "Se lee del centro hacia fuera, en sentido contrario a las agujas del reloj; las hileras, de abajo arriba. Cada casilla es un punto en el color de su hilo.",
    "step": "Paso {n}", "new": "Lo nuevo está a todo color.", "care": "Cuidado",
    "care text": "Lavar a mano en agua fresca con un poco de jabón suave, escurrir en una toalla, dar forma y secar en plano. Para un niño de menos de tres años, bordar los ojos en lugar de ponerlos de plástico y coser cada pieza dos veces.",
    "made": "Tamaño, hilo y muestra están calculados a partir de los puntos; tu mano puede variar.",
    "notes": "Cómo se lee",
    "notes text": "Un número delante de un punto dice cuántos hacer, cada uno en su propio punto. Los corchetes se repiten tantas veces como se dice después. El número entre paréntesis es el de puntos al final de la vuelta. Marca la casilla cuando termines una vuelta.",
    "front": "de frente", "right": "desde la derecha", "back": "de espaldas", "a eye": "Ojos", "a felt": "Fieltro", "a embroidery": "Bordado", "a hair": "Pelo",
}  # fmt: skip

_NL: Final = {
    "pattern": "Haakpatroon amigurumi", "by": "door {name}", "before": "Voor je begint", "width": "breedte",
    "height": "hoogte", "depth": "diepte", "around": "omtrek van de wijdste toer", "hook": "haaknaald",
    "stuffing": "Vulling", "notions": "Verder nodig", "needle": "stompe naald, om de delen aan elkaar te naaien",
    "ends": "stompe naald, om de draden weg te werken", "marker": "stekenmarkeerder, voor de eerste steek van elke toer",
    "scissors": "schaar", "eyes": "{n} veiligheidsogen, {size} mm", "eye": "1 veiligheidsoog, {size} mm",
    "embroidery": "{cm} cm, om te borduren", "felt": "vilt, {n} × {w} × {h} mm",
    "hair": "{n} draden van {cm} cm, voor het haar", "fill": "vulling van polyester, ongeveer {grams} g ({litres} l)",
    "skein": "1 bol van {grams} g", "skeins": "{n} bollen van {grams} g", "weight": "garendikte {name} ({number})",
    "typical": "De grammen gelden voor gewoon garen van deze dikte ({name}), {metres} m op 100 g; een tiende is reserve.",
    "swatch": "Plat: {stitches} v en {rows} toeren op 10 cm.",
    "circle": "Cirkel: vijf toeren (6, 12, 18, 24, 30) meten {cm} cm.",
    "tight": "Haak zo strak dat de vulling niet te zien is. Met een andere stekenverhouding verandert de maat evenredig.",
    "expected": "Er is geen stekenverhouding opgegeven: dit is wat bij dit garen en deze naald te verwachten is.",
    "stuffed": "Gevuld gemeten.", "stuffed, sitting": "Gevuld en zittend gemeten.",
    "stuffed, standing": "Gevuld en staand gemeten.", "laid flat": "Plat gemeten.", "as it lies": "Liggend gemeten.",
    "continued": "vervolg", "charts": "Telpatronen",
    "chart note": "Lees van het midden naar buiten, tegen de klok in; rijen van onder naar boven. Elk vak is een steek in de kleur van het garen.",
    "step": "Stap {n}", "new": "Wat nieuw is, staat in volle kleur.", "care": "Onderhoud",
    "care text": "Was met de hand in koel water met wat milde zeep, druk uit in een handdoek, breng in vorm en laat liggend drogen. Borduur voor een kind onder de drie jaar de ogen in plaats van plastic ogen te gebruiken en naai elk deel dubbel vast.",
    "made": "Maat, garen en stekenverhouding zijn uit de steken berekend; je eigen hand kan afwijken.",
    "notes": "Zo lees je het patroon",
    "notes text": "Een getal voor een steek zegt hoeveel je er haakt, elk in een eigen steek. Vierkante haken herhaal je zo vaak als erachter staat. Het getal tussen ronde haken is het aantal steken aan het einde van de toer. Vink het vakje af als een toer klaar is.",
    "front": "van voren", "right": "van rechts", "back": "van achteren", "a eye": "Ogen", "a felt": "Vilt", "a embroidery": "Borduurwerk", "a hair": "Haar",
}  # fmt: skip

WORDS: Final = {"us": _US, "letters": {**_US, "swatch": "Flat: {stitches} X and {rows} rows in 10 cm (4 in)."},
                "uk": _UK, "de": _DE, "fr": _FR, "es": _ES, "nl": _NL}  # fmt: skip
"""Code of the terms → the page's words."""

IMPERIAL: Final = ("us", "uk", "letters")
"""Terms whose readers also want inches and yards."""
