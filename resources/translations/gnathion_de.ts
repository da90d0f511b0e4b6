<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>BonePanel</name>
    <message>
        <source>Bone surface</source>
        <translation>Knochenoberfläche</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>S&amp;chwelle</translation>
    </message>
    <message>
        <source>Where the bone begins, in Hounsfield units: a coarse surface follows the slider, the exact one is made when it is let go</source>
        <translation>Ab welchem Hounsfield-Wert Knochen beginnt: eine grobe Oberfläche folgt dem Regler, die genaue entsteht beim Loslassen</translation>
    </message>
    <message>
        <source>Where the bone begins, in Hounsfield units (HU): lower shows thinner bone, higher keeps jaws and teeth apart</source>
        <translation>Ab welchem Wert in Hounsfield-Einheiten (HU) Knochen beginnt: niedriger zeigt dünneren Knochen, höher hält Kiefer und Zähne getrennt</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> HU</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>The pieces of bone that are moved: tick to show, double-click to rename; volume in cm³</source>
        <translation>Die Knochenstücke, die bewegt werden: Häkchen zum Anzeigen, Doppelklick zum Umbenennen; Volumen in cm³</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Ch&amp;ange its cut</source>
        <translation>Schni&amp;tt ändern</translation>
    </message>
    <message>
        <source>Place the cut of the chosen segment anew</source>
        <translation>Den Schnitt des gewählten Segments neu setzen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take the chosen segment out of the plan: its bone goes back to the skull</source>
        <translation>Das gewählte Segment aus dem Plan nehmen: sein Knochen kehrt zum Schädel zurück</translation>
    </message>
    <message>
        <source>New cut</source>
        <translation>Neuer Schnitt</translation>
    </message>
    <message>
        <source>Ch&amp;in</source>
        <translation>Ki&amp;nn</translation>
    </message>
    <message>
        <source>Genioplasty: a blade below the roots of the lower front teeth, to be adjusted</source>
        <translation>Genioplastik: ein Sägeblatt unterhalb der Wurzeln der unteren Frontzähne, zum Anpassen</translation>
    </message>
    <message>
        <source>Sa&amp;gittal split</source>
        <translation>Sa&amp;g. Spaltung</translation>
    </message>
    <message>
        <source>Both sides: a box that takes the tooth-bearing part of the lower jaw, to be adjusted. Simplified: straight behind the last molars</source>
        <translation>Beidseits: ein Quader, der den zahntragenden Teil des Unterkiefers nimmt, zum Anpassen. Vereinfacht: gerade hinter den letzten Molaren</translation>
    </message>
    <message>
        <source>Le For&amp;t I</source>
        <translation>&amp;Le Fort I</translation>
    </message>
    <message>
        <source>The upper jaw with its teeth: a box up to above the floor of the nose, to be adjusted</source>
        <translation>Der Oberkiefer mit seinen Zähnen: ein Quader bis über den Nasenboden, zum Anpassen</translation>
    </message>
    <message>
        <source>Bla&amp;de</source>
        <translation>&amp;Sägeblatt</translation>
    </message>
    <message>
        <source>A free saw blade: the piece below it comes off</source>
        <translation>Ein freies Sägeblatt: das Stück darunter löst sich</translation>
    </message>
    <message>
        <source>Bo&amp;x</source>
        <translation>&amp;Quader</translation>
    </message>
    <message>
        <source>A free box: the bone inside it comes off</source>
        <translation>Ein freier Quader: der Knochen darin löst sich</translation>
    </message>
    <message>
        <source>The cut</source>
        <translation>Der Schnitt</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>Na&amp;me</translation>
    </message>
    <message>
        <source>What the piece is called that comes off</source>
        <translation>Wie das Stück heißt, das sich löst</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>How far the cut is moved forward, in mm; negative: back</source>
        <translation>Wie weit der Schnitt nach vorn verschoben ist, in mm; negativ: nach hinten</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>How far the cut is moved up, in mm; negative: down</source>
        <translation>Wie weit der Schnitt nach oben verschoben ist, in mm; negativ: nach unten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>How far the cut is moved to the patient’s left, in mm; negative: to the right</source>
        <translation>Wie weit der Schnitt zur linken Seite des Patienten verschoben ist, in mm; negativ: nach rechts</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Pitch</translation>
    </message>
    <message>
        <source>How far the cut is turned about the left–right axis, in degrees; positive: its front rises</source>
        <translation>Wie weit der Schnitt um die Links-rechts-Achse gedreht ist, in Grad; positiv: vorn höher</translation>
    </message>
    <message>
        <source> °</source>
        <translation> °</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Roll</translation>
    </message>
    <message>
        <source>How far the cut is turned about the front–back axis, in degrees; positive: its left side rises</source>
        <translation>Wie weit der Schnitt um die Achse von vorn nach hinten gedreht ist, in Grad; positiv: links höher</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Yaw</translation>
    </message>
    <message>
        <source>How far the cut is turned about the vertical axis, in degrees; positive: its front goes to the patient’s left</source>
        <translation>Wie weit der Schnitt um die senkrechte Achse gedreht ist, in Grad; positiv: vorn zur linken Seite des Patienten</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>From side to side, in mm</source>
        <translation>Von Seite zu Seite, in mm</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>From front to back, in mm</source>
        <translation>Von vorn nach hinten, in mm</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>From bottom to top, in mm; of a blade: what the saw takes away</source>
        <translation>Von unten nach oben, in mm; beim Sägeblatt: was die Säge wegnimmt</translation>
    </message>
    <message>
        <source>A blade parts the bone in two: which of the two comes off</source>
        <translation>Ein Sägeblatt teilt den Knochen in zwei Stücke: welches von beiden sich löst</translation>
    </message>
    <message>
        <source>C&amp;ut</source>
        <translation>D&amp;urchtrennen</translation>
    </message>
    <message>
        <source>Cut the bone: a step that can be undone</source>
        <translation>Den Knochen durchtrennen: ein Schritt, der sich rückgängig machen lässt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leave the bone as it is (Esc)</source>
        <translation>Den Knochen lassen, wie er ist (Esc)</translation>
    </message>
    <message>
        <source>Sho&amp;w the face, too</source>
        <translation>Gesicht mit an&amp;zeigen</translation>
    </message>
    <message>
        <source>The face over the bone; how opaque it is, is set in the bar above</source>
        <translation>Das Gesicht über dem Knochen; seine Deckkraft stellt die Leiste oben ein</translation>
    </message>
    <message>
        <source>Take the other &amp;side of the blade</source>
        <translation>Andere Se&amp;ite des Sägeblatts nehmen</translation>
    </message>
</context>
<context>
    <name>ComparePanel</name>
    <message>
        <source>Before and predicted</source>
        <translation>Vorher und Vorhersage</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>An&amp;zeige</translation>
    </message>
    <message>
        <source>How the face before and the predicted face are laid side by side</source>
        <translation>Wie das Gesicht vorher und das vorhergesagte nebeneinander gelegt werden</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Wischen</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überblenden</translation>
    </message>
    <message>
        <source>Profile outlines</source>
        <translation>Profillinien</translation>
    </message>
    <message>
        <source>Predicted face alone</source>
        <translation>Nur das vorhergesagte Gesicht</translation>
    </message>
    <message>
        <source>D&amp;ivider</source>
        <translation>&amp;Trennlinie</translation>
    </message>
    <message>
        <source>Where the picture changes from before (left) to predicted (right); the line in the view can be dragged, too</source>
        <translation>Wo das Bild von vorher (links) zur Vorhersage (rechts) wechselt; die Linie in der Ansicht lässt sich auch ziehen</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>How much of the face before is laid over the predicted one, 0 to 100 %</source>
        <translation>Wie stark das Gesicht vorher über dem vorhergesagten liegt, 0 bis 100 %</translation>
    </message>
    <message>
        <source>Plane &amp;at</source>
        <translation>Eb&amp;ene bei</translation>
    </message>
    <message>
        <source>Where the profile is taken: mm to the patient&apos;s left of the middle of the face; below zero: to the right</source>
        <translation>Wo das Profil liegt: mm zur linken Seite des Patienten ab der Gesichtsmitte; unter null: nach rechts</translation>
    </message>
    <message>
        <source> mm left of the middle</source>
        <translation> mm links der Mitte</translation>
    </message>
    <message>
        <source>Signed change of the face in mm: red forward of the face before, blue behind it</source>
        <translation>Vorzeichenbehaftete Änderung des Gesichts in mm: rot vor dem bisherigen Gesicht, blau dahinter</translation>
    </message>
    <message>
        <source>Colour ma&amp;p of the change</source>
        <translation>Farbkarte der Änder&amp;ung</translation>
    </message>
    <message>
        <source>Its ran&amp;ge</source>
        <translation>Bere&amp;ich</translation>
    </message>
    <message>
        <source>mm at the two ends of the colours; automatic: a round number that 99 % of the change keeps within</source>
        <translation>mm an den beiden Enden der Farben; automatisch: eine runde Zahl, die 99 % der Änderung umfasst</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>± </source>
        <translation>± </translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Change over the region, mm</source>
        <translation>Änderung in der Region, mm</translation>
    </message>
    <message>
        <source>In mm, over all points of the region. Signed change: distance to the face before, its sign left out. Estimated error: of the model, not of the plan, the images or the material.</source>
        <translation>In mm, über alle Punkte der Region. Änderung: Abstand zum Gesicht vorher, ohne Vorzeichen. Geschätzter Fehler: der des Modells, nicht der des Plans, der Bilder oder des Materials.</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Signed change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Estimated error</source>
        <translation>Gesch. Fehler</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max.</translation>
    </message>
    <message>
        <source>Volume between the face before and the predicted face, in cm³: positive where the face gains. ±: the mean estimated error times the region&apos;s area.</source>
        <translation>Volumen zwischen dem Gesicht vorher und dem vorhergesagten, in cm³: positiv, wo das Gesicht gewinnt. ±: mittlerer geschätzter Fehler mal Fläche der Region.</translation>
    </message>
    <message>
        <source>What the histogram counts, in mm</source>
        <translation>Was das Histogramm zählt, in mm</translation>
    </message>
    <message>
        <source>Histogram of the signed change</source>
        <translation>Histogramm der Änderung</translation>
    </message>
    <message>
        <source>Histogram of the displacement</source>
        <translation>Histogramm der Verschiebung</translation>
    </message>
    <message>
        <source>Under the cursor</source>
        <translation>Unter dem Mauszeiger</translation>
    </message>
    <message>
        <source>Point at the face to read its change.</source>
        <translation>Auf das Gesicht zeigen, um seine Änderung abzulesen.</translation>
    </message>
    <message>
        <source>Two clicks on the face give the distance between the points before and after, in mm</source>
        <translation>Zwei Klicks auf das Gesicht ergeben den Abstand der Punkte vorher und nachher, in mm</translation>
    </message>
    <message>
        <source>Meas&amp;ure a distance</source>
        <translation>Strecke &amp;messen</translation>
    </message>
    <message>
        <source>Take the measured distance out of the view</source>
        <translation>Die gemessene Strecke aus der Ansicht nehmen</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Löschen</translation>
    </message>
</context>
<context>
    <name>HiddenCanvas</name>
    <message>
        <source>pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>the display gives no second OpenGL 3.2 context</source>
        <translation>die Anzeige bietet keinen zweiten OpenGL-3.2-Kontext</translation>
    </message>
    <message>
        <source>close other programs that draw in 3D and try again</source>
        <translation>andere Programme schließen, die dreidimensional zeichnen, und es noch einmal versuchen</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Gnathion</source>
        <translation>Gnathion</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Th&amp;eme</source>
        <translation>Farbs&amp;chema</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>T&amp;urn and zoom</source>
        <translation>Dr&amp;ehen und zoomen</translation>
    </message>
    <message>
        <source>&amp;Slices</source>
        <translation>&amp;Schichten</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>File tools</source>
        <translation>Dateileiste</translation>
    </message>
    <message>
        <source>View tools</source>
        <translation>Ansichtsleiste</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Planung</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>Be&amp;wegen</translation>
    </message>
    <message>
        <source>&amp;Save case</source>
        <translation>Fall &amp;speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the case with its history (Ctrl+S)</source>
        <translation>Den Fall mit seinem Verlauf speichern (Strg+S)</translation>
    </message>
    <message>
        <source>Save case &amp;as…</source>
        <translation>Fall speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the case into another file (Ctrl+Shift+S)</source>
        <translation>Den Fall in eine andere Datei speichern (Strg+Umschalt+S)</translation>
    </message>
    <message>
        <source>&amp;Tissue model…</source>
        <translation>&amp;Gewebemodell…</translation>
    </message>
    <message>
        <source>What the tissue is made of, and how exactly it is computed (Ctrl+T)</source>
        <translation>Woraus das Gewebe besteht und wie genau es berechnet wird (Strg+T)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Take the last step back (Ctrl+Z)</source>
        <translation>Den letzten Schritt zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wieder</translation>
    </message>
    <message>
        <source>Do again what was taken back (Ctrl+Shift+Z)</source>
        <translation>Den zurückgenommenen Schritt wieder ausführen (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>&amp;Open case…</source>
        <translation>Fall ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a case file (Ctrl+O)</source>
        <translation>Eine Falldatei öffnen (Strg+O)</translation>
    </message>
    <message>
        <source>Open &amp;demo case</source>
        <translation>&amp;Demofall öffnen</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Demo</translation>
    </message>
    <message>
        <source>Open the embedded demo case (Ctrl+D)</source>
        <translation>Den eingebauten Demofall öffnen (Strg+D)</translation>
    </message>
    <message>
        <source>&amp;Import a DICOM folder…</source>
        <translation>DICOM-Ordner &amp;importieren…</translation>
    </message>
    <message>
        <source>A new case from a CT series in a folder of DICOM files (Ctrl+I)</source>
        <translation>Ein neuer Fall aus einer CT-Serie in einem Ordner mit DICOM-Dateien (Strg+I)</translation>
    </message>
    <message>
        <source>Import an image &amp;volume…</source>
        <translation>Bild&amp;volumen importieren…</translation>
    </message>
    <message>
        <source>A new case from a volume in Hounsfield units: .mha, .mhd, .nrrd, .nhdr, .nii, .nii.gz</source>
        <translation>Ein neuer Fall aus einem Volumen in Hounsfield-Einheiten: .mha, .mhd, .nrrd, .nhdr, .nii, .nii.gz</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;System</translation>
    </message>
    <message>
        <source>The colours of the desktop</source>
        <translation>Die Farben des Desktops</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Dark letters on light ground</source>
        <translation>Dunkle Schrift auf hellem Grund</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Light letters on dark ground</source>
        <translation>Helle Schrift auf dunklem Grund</translation>
    </message>
    <message>
        <source>The language of the desktop, at the next start</source>
        <translation>Die Sprache des Desktops, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>English, at the next start</source>
        <translation>Englisch, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>German, at the next start</source>
        <translation>Deutsch, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>&amp;Export predicted face…</source>
        <translation>Vorhergesagtes Gesicht &amp;exportieren…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Write the predicted face into a new folder (Ctrl+E)</source>
        <translation>Das vorhergesagte Gesicht in einen neuen Ordner schreiben (Strg+E)</translation>
    </message>
    <message>
        <source>Export &amp;bones as STL…</source>
        <translation>&amp;Knochen als STL exportieren…</translation>
    </message>
    <message>
        <source>Write the segments in their planned places and the remaining bone into a new folder: STL, mm, LPS</source>
        <translation>Die Segmente an ihrem geplanten Ort und den übrigen Knochen in einen neuen Ordner schreiben: STL, mm, LPS</translation>
    </message>
    <message>
        <source>Export &amp;turning face…</source>
        <translation>Gesicht in Drehung expor&amp;tieren…</translation>
    </message>
    <message>
        <source>A film, or pictures, of the face turning once round</source>
        <translation>Ein Film oder Bilder vom Gesicht, das sich einmal um sich dreht</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>&amp;Bild speichern…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Save the 3D view as a PNG picture (Ctrl+P)</source>
        <translation>Die 3D-Ansicht als PNG-Bild speichern (Strg+P)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Bee&amp;nden</translation>
    </message>
    <message>
        <source>Close the window (Ctrl+Q)</source>
        <translation>Das Fenster schließen (Strg+Q)</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>From the front (keypad 1)</source>
        <translation>Von vorn (Ziffernblock 1)</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>The patient&apos;s left profile (keypad 3)</source>
        <translation>Das linke Profil des Patienten (Ziffernblock 3)</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>The patient&apos;s right profile (keypad 9)</source>
        <translation>Das rechte Profil des Patienten (Ziffernblock 9)</translation>
    </message>
    <message>
        <source>&amp;Three-quarter</source>
        <translation>&amp;Dreiviertel</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Schräg</translation>
    </message>
    <message>
        <source>From the front, turned to the patient&apos;s left (keypad 5)</source>
        <translation>Von vorn, zur linken Seite des Patienten gedreht (Ziffernblock 5)</translation>
    </message>
    <message>
        <source>To&amp;p</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>From above (keypad 7)</source>
        <translation>Von oben (Ziffernblock 7)</translation>
    </message>
    <message>
        <source>Reset vie&amp;w</source>
        <translation>Ansicht &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>The three-quarter view that a case opens with (R)</source>
        <translation>Die Dreiviertelansicht, mit der ein Fall aufgeht (R)</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>The eye goes 15° round to the picture&apos;s left (keypad 4)</source>
        <translation>Das Auge geht 15° zur linken Seite des Bildes herum (Ziffernblock 4)</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>The eye goes 15° round to the picture&apos;s right (keypad 6)</source>
        <translation>Das Auge geht 15° zur rechten Seite des Bildes herum (Ziffernblock 6)</translation>
    </message>
    <message>
        <source>Turn &amp;up</source>
        <translation>Nach &amp;oben drehen</translation>
    </message>
    <message>
        <source>The eye goes 15° up (keypad 8)</source>
        <translation>Das Auge geht 15° nach oben (Ziffernblock 8)</translation>
    </message>
    <message>
        <source>Turn &amp;down</source>
        <translation>Nach &amp;unten drehen</translation>
    </message>
    <message>
        <source>The eye goes 15° down (keypad 2)</source>
        <translation>Das Auge geht 15° nach unten (Ziffernblock 2)</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Larger: the 3D view, or the slice that has the focus (Ctrl and +)</source>
        <translation>Größer: die 3D-Ansicht oder die Schicht, die den Fokus hat (Strg und +)</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Smaller: the 3D view, or the slice that has the focus (Ctrl and −)</source>
        <translation>Kleiner: die 3D-Ansicht oder die Schicht, die den Fokus hat (Strg und −)</translation>
    </message>
    <message>
        <source>&amp;Maximise the view</source>
        <translation>Ansicht &amp;maximieren</translation>
    </message>
    <message>
        <source>All the room for the view that has the focus, or for all views again (Ctrl+M, or a double click in a view)</source>
        <translation>Der ganze Platz für die Ansicht, die den Fokus hat, oder wieder für alle (Strg+M oder ein Doppelklick in eine Ansicht)</translation>
    </message>
    <message>
        <source>Axial, coronal and sagittal slices of the CT beside the 3D view (F9). Shift and the mouse over the 3D view show what lies there</source>
        <translation>Axiale, koronale und sagittale Schichten des CT neben der 3D-Ansicht (F9). Umschalt und die Maus über der 3D-Ansicht zeigen, was dort liegt</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>&amp;Umrisse</translation>
    </message>
    <message>
        <source>Bone, segments and skin outlined in the slices (Ctrl+L)</source>
        <translation>Umrisse von Knochen, Segmenten und Haut in den Schichten (Strg+L)</translation>
    </message>
    <message>
        <source>&amp;Bone window</source>
        <translation>&amp;Knochenfenster</translation>
    </message>
    <message>
        <source>Greys of the slices for bone: level 500, width 2500 HU (Ctrl+1)</source>
        <translation>Grauwerte der Schichten für Knochen: Zentrum 500, Breite 2500 HU (Strg+1)</translation>
    </message>
    <message>
        <source>Soft &amp;tissue window</source>
        <translation>&amp;Weichteilfenster</translation>
    </message>
    <message>
        <source>Greys of the slices for soft tissue: level 50, width 400 HU (Ctrl+2)</source>
        <translation>Grauwerte der Schichten für Weichgewebe: Zentrum 50, Breite 400 HU (Strg+2)</translation>
    </message>
    <message>
        <source>S&amp;kin window</source>
        <translation>&amp;Hautfenster</translation>
    </message>
    <message>
        <source>Greys of the slices for the skin against the air: level −300, width 1000 HU (Ctrl+3)</source>
        <translation>Grauwerte der Schichten für die Haut gegen die Luft: Zentrum −300, Breite 1000 HU (Strg+3)</translation>
    </message>
    <message>
        <source>P&amp;hotograph</source>
        <translation>&amp;Foto</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>The photograph&apos;s texture on the face, or plain skin, which shows the shape better (T)</source>
        <translation>Die Textur des Fotos auf dem Gesicht oder schlichte Haut, die die Form besser zeigt (T)</translation>
    </message>
    <message>
        <source>Skull and jaw segment (B)</source>
        <translation>Schädel und Kiefersegment (B)</translation>
    </message>
    <message>
        <source>&amp;Colour map</source>
        <translation>F&amp;arbkarte</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Signed change of the face in mm: red forward of the face before, blue behind it (C)</source>
        <translation>Vorzeichenbehaftete Änderung des Gesichts in mm: rot vor dem bisherigen Gesicht, blau dahinter (C)</translation>
    </message>
    <message>
        <source>Face &amp;before</source>
        <translation>Gesicht vor&amp;her</translation>
    </message>
    <message>
        <source>The face and the segment before any motion (Space to compare)</source>
        <translation>Gesicht und Segment vor jeder Bewegung (Leertaste zum Vergleichen)</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Play motio&amp;n</source>
        <translation>Bewegung a&amp;bspielen</translation>
    </message>
    <message>
        <source>How the face follows the bone in time, as damped motion, slowly; again to stop (P)</source>
        <translation>Wie das Gesicht dem Knochen in der Zeit folgt, als gedämpfte Bewegung, verlangsamt; noch einmal zum Anhalten (P)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Ablauf</translation>
    </message>
    <message>
        <source>&amp;About Gnathion</source>
        <translation>&amp;Über Gnathion</translation>
    </message>
    <message>
        <source>Licence and research-use notice</source>
        <translation>Lizenz und Hinweis auf die Forschungsnutzung</translation>
    </message>
    <message>
        <source>B&amp;one</source>
        <translation>&amp;Knochen</translation>
    </message>
</context>
<context>
    <name>MessageBar</name>
    <message>
        <source>✕</source>
        <translation>✕</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>MotionPanel</name>
    <message>
        <source>The segment that the numbers and the grips in the view move; a click on it in the view chooses it, too, when the skin is see-through</source>
        <translation>Das Segment, das die Zahlen und die Griffe in der Ansicht bewegen; bei durchscheinender Haut wählt es auch ein Klick darauf</translation>
    </message>
    <message>
        <source>Where moved bone runs into other bone by more than 0.3 mm, and how deep; red in the view</source>
        <translation>Wo bewegter Knochen mehr als 0.3 mm in anderen Knochen dringt und wie tief; rot in der Ansicht</translation>
    </message>
    <message>
        <source>Move the segment</source>
        <translation>Segment bewegen</translation>
    </message>
    <message>
        <source>For&amp;ward + / back −</source>
        <translation>Nach v&amp;orn + / hinten −</translation>
    </message>
    <message>
        <source>How far forward, in mm; negative: back</source>
        <translation>Wie weit nach vorn, in mm; negativ: nach hinten</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Up + / down −</source>
        <translation>Nach oben + / u&amp;nten −</translation>
    </message>
    <message>
        <source>How far up, in mm; negative: down</source>
        <translation>Wie weit nach oben, in mm; negativ: nach unten</translation>
    </message>
    <message>
        <source>&amp;Left + / right −</source>
        <translation>Nach &amp;links + / rechts −</translation>
    </message>
    <message>
        <source>How far to the patient&apos;s left, in mm; negative: to the right</source>
        <translation>Wie weit zur linken Seite des Patienten, in mm; negativ: nach rechts</translation>
    </message>
    <message>
        <source>&amp;Pitch, chin up +</source>
        <translation>&amp;Pitch, Kinn hoch +</translation>
    </message>
    <message>
        <source>Turn about the left–right axis through the segment&apos;s pivot, in degrees; positive lifts the chin</source>
        <translation>Drehung um die Links-rechts-Achse durch den Drehpunkt des Segments, in Grad; positiv hebt das Kinn</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Roll, lef&amp;t side up +</source>
        <translation>Roll, l&amp;inks hoch +</translation>
    </message>
    <message>
        <source>Turn about the front–back axis, in degrees; positive lifts the patient&apos;s left side</source>
        <translation>Drehung um die Achse von vorn nach hinten, in Grad; positiv hebt die linke Seite des Patienten</translation>
    </message>
    <message>
        <source>&amp;Yaw, chin to left +</source>
        <translation>&amp;Yaw, Kinn links +</translation>
    </message>
    <message>
        <source>Turn about the vertical axis, in degrees; positive turns the chin to the patient&apos;s left</source>
        <translation>Drehung um die senkrechte Achse, in Grad; positiv dreht das Kinn zur linken Seite des Patienten</translation>
    </message>
    <message>
        <source>Hi&amp;nge, closing +</source>
        <translation>Scharnier, schließ&amp;t +</translation>
    </message>
    <message>
        <source>How far the segment is turned about the axis through the condyles, in degrees; positive closes the mouth. Typing turns it about that axis, whatever the pivot</source>
        <translation>Wie weit das Segment um die Achse durch die Kondylen gedreht ist, in Grad; positiv schließt den Mund. Eine eingegebene Zahl dreht um diese Achse, gleich welcher Drehpunkt gilt</translation>
    </message>
    <message>
        <source>Only</source>
        <translation>Nur</translation>
    </message>
    <message>
        <source>Keep the grips in the view to the left–right axis: to the sides, and pitch (key X)</source>
        <translation>Die Griffe der Ansicht auf die Links-rechts-Achse beschränken: zu den Seiten und Pitch (Taste X)</translation>
    </message>
    <message>
        <source>Left–right</source>
        <translation>Seitlich</translation>
    </message>
    <message>
        <source>Keep the grips in the view to the front–back axis: forward and back, and roll (key Y)</source>
        <translation>Die Griffe der Ansicht auf die Achse von vorn nach hinten beschränken: vor, zurück und Roll (Taste Y)</translation>
    </message>
    <message>
        <source>Front–back</source>
        <translation>Vor–zurück</translation>
    </message>
    <message>
        <source>Keep the grips in the view to the vertical axis: up and down, and yaw (key Z)</source>
        <translation>Die Griffe der Ansicht auf die senkrechte Achse beschränken: nach oben, nach unten und Yaw (Taste Z)</translation>
    </message>
    <message>
        <source>Up–down</source>
        <translation>Auf–ab</translation>
    </message>
    <message>
        <source>Show in the view where the segment was before it was moved</source>
        <translation>In der Ansicht zeigen, wo das Segment vor der Bewegung war</translation>
    </message>
    <message>
        <source>Show where &amp;it was</source>
        <translation>A&amp;usgangslage zeigen</translation>
    </message>
    <message>
        <source>Back to where the segment was before any motion</source>
        <translation>Dorthin zurück, wo das Segment vor jeder Bewegung war</translation>
    </message>
    <message>
        <source>Re&amp;set motion</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Or drag in the view: the yellow ball shifts, the coloured balls keep to one axis, the rings turn.</source>
        <translation>Oder in der Ansicht ziehen: die gelbe Kugel verschiebt, die farbigen Kugeln halten sich an eine Achse, die Ringe drehen.</translation>
    </message>
    <message>
        <source>Turns are about</source>
        <translation>Drehen um</translation>
    </message>
    <message>
        <source>The point about which the degrees turn the segment; changing it does not move the bone</source>
        <translation>Der Punkt, um den die Grade das Segment drehen; ihn zu ändern bewegt den Knochen nicht</translation>
    </message>
    <message>
        <source>Centre of the segment</source>
        <translation>Mitte des Segments</translation>
    </message>
    <message>
        <source>Middle of the hinge axis</source>
        <translation>Mitte der Scharnierachse</translation>
    </message>
    <message>
        <source>Most forward point</source>
        <translation>Vorderster Punkt</translation>
    </message>
    <message>
        <source>Typed point</source>
        <translation>Eingegebener Punkt</translation>
    </message>
    <message>
        <source>x, to the left</source>
        <translation>x, nach links</translation>
    </message>
    <message>
        <source>Where the pivot is, in mm towards the patient&apos;s left, in the CT&apos;s patient frame (LPS)</source>
        <translation>Wo der Drehpunkt liegt, in mm zur linken Seite des Patienten, im Patientensystem des CT (LPS)</translation>
    </message>
    <message>
        <source>y, to the back</source>
        <translation>y, nach hinten</translation>
    </message>
    <message>
        <source>Where the pivot is, in mm to the back, in the CT&apos;s patient frame (LPS)</source>
        <translation>Wo der Drehpunkt liegt, in mm nach hinten, im Patientensystem des CT (LPS)</translation>
    </message>
    <message>
        <source>z, up</source>
        <translation>z, nach oben</translation>
    </message>
    <message>
        <source>Where the pivot is, in mm up, in the CT&apos;s patient frame (LPS)</source>
        <translation>Wo der Drehpunkt liegt, in mm nach oben, im Patientensystem des CT (LPS)</translation>
    </message>
    <message>
        <source>Show and type the two points of the hinge axis</source>
        <translation>Die beiden Punkte der Scharnierachse zeigen und eingeben</translation>
    </message>
    <message>
        <source>A&amp;xis…</source>
        <translation>A&amp;chse…</translation>
    </message>
    <message>
        <source>Right condyle: x, y, z</source>
        <translation>Rechter Kondylus: x, y, z</translation>
    </message>
    <message>
        <source>Centre of the right condyle, in mm towards the patient&apos;s left (LPS)</source>
        <translation>Mitte des rechten Kondylus, in mm zur linken Seite des Patienten (LPS)</translation>
    </message>
    <message>
        <source>Centre of the right condyle, in mm to the back (LPS)</source>
        <translation>Mitte des rechten Kondylus, in mm nach hinten (LPS)</translation>
    </message>
    <message>
        <source>Centre of the right condyle, in mm up (LPS)</source>
        <translation>Mitte des rechten Kondylus, in mm nach oben (LPS)</translation>
    </message>
    <message>
        <source>Left condyle: x, y, z</source>
        <translation>Linker Kondylus: x, y, z</translation>
    </message>
    <message>
        <source>Centre of the left condyle, in mm towards the patient&apos;s left (LPS)</source>
        <translation>Mitte des linken Kondylus, in mm zur linken Seite des Patienten (LPS)</translation>
    </message>
    <message>
        <source>Centre of the left condyle, in mm to the back (LPS)</source>
        <translation>Mitte des linken Kondylus, in mm nach hinten (LPS)</translation>
    </message>
    <message>
        <source>Centre of the left condyle, in mm up (LPS)</source>
        <translation>Mitte des linken Kondylus, in mm nach oben (LPS)</translation>
    </message>
    <message>
        <source>Take the typed points as the hinge axis</source>
        <translation>Die eingegebenen Punkte als Scharnierachse nehmen</translation>
    </message>
    <message>
        <source>Use this &amp;axis</source>
        <translation>Achse v&amp;erwenden</translation>
    </message>
    <message>
        <source>Look for the condyles on the bone again</source>
        <translation>Die Kondylen noch einmal am Knochen suchen</translation>
    </message>
    <message>
        <source>Fin&amp;d</source>
        <translation>&amp;Suchen</translation>
    </message>
    <message>
        <source>How far the face moves</source>
        <translation>Wie weit sich das Gesicht bewegt</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Of the region, in mm</source>
        <translation>Der Region, in mm</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95. Perzentil</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>Landmarks of the face</source>
        <translation>Landmarken des Gesichts</translation>
    </message>
    <message>
        <source>How far each landmark of the skin moves, and that as a part of how far bone fixed to the segment would move there</source>
        <translation>Wie weit sich jede Landmarke der Haut bewegt, und dies als Teil dessen, was sich mit dem Segment verbundener Knochen dort bewegen würde</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>of bone</source>
        <translation>vom Knochen</translation>
    </message>
    <message>
        <source>The case file names no landmarks (key &quot;landmarks&quot;).</source>
        <translation>Die Falldatei nennt keine Landmarken (Schlüssel „landmarks“).</translation>
    </message>
</context>
<context>
    <name>PhotographDialog</name>
    <message>
        <source>Add a photograph</source>
        <translation>Foto hinzufügen</translation>
    </message>
    <message>
        <source>Its lengths are in</source>
        <translation>Seine Längen sind in</translation>
    </message>
    <message>
        <source>Unit of length of the photograph</source>
        <translation>Längeneinheit des Fotos</translation>
    </message>
    <message>
        <source>A scan does not say its unit: ask who made it</source>
        <translation>Eine Aufnahme nennt ihre Einheit nicht: fragen Sie, wer sie gemacht hat</translation>
    </message>
    <message>
        <source>choose the unit</source>
        <translation>Einheit wählen</translation>
    </message>
    <message>
        <source>millimetres (mm)</source>
        <translation>Millimeter (mm)</translation>
    </message>
    <message>
        <source>centimetres (cm)</source>
        <translation>Zentimeter (cm)</translation>
    </message>
    <message>
        <source>metres (m)</source>
        <translation>Meter (m)</translation>
    </message>
    <message>
        <source>Looking at its size…</source>
        <translation>Die Größe wird geprüft…</translation>
    </message>
    <message>
        <source>It has to be &amp;fitted to the CT: done next, and shown as a proposal</source>
        <translation>Es muss an das CT an&amp;gepasst werden: geschieht als Nächstes und wird als Vorschlag gezeigt</translation>
    </message>
    <message>
        <source>The photograph is turned and moved onto the CT&apos;s skin in the step Photograph</source>
        <translation>Das Foto wird im Schritt Foto auf die Haut des CT gedreht und geschoben</translation>
    </message>
    <message>
        <source>It &amp;lies on the CT already: same origin and axes as the CT
(x to the patient&apos;s left, y to the back, z up)</source>
        <translation>Es &amp;liegt schon auf dem CT: gleicher Ursprung und gleiche Achsen wie das CT
(x zur linken Seite des Patienten, y nach hinten, z nach oben)</translation>
    </message>
    <message>
        <source>The photograph is used where it is, without moving or turning it</source>
        <translation>Das Foto wird verwendet, wo es liegt, ohne es zu verschieben oder zu drehen</translation>
    </message>
    <message>
        <source>The photograph takes the place of the present face. A region that was painted on that face is not kept; Undo brings it back.</source>
        <translation>Das Foto tritt an die Stelle des jetzigen Gesichts. Eine Region, die auf jenem Gesicht gemalt wurde, bleibt nicht erhalten; Rückgängig bringt sie wieder.</translation>
    </message>
</context>
<context>
    <name>PhotographsDialog</name>
    <message>
        <source>Project photographs onto the CT&apos;s skin</source>
        <translation>Fotos auf die Haut des CT projizieren</translation>
    </message>
    <message>
        <source>Which photograph is shown; the first gives the others its colours: begin with that from the front</source>
        <translation>Welches Foto gezeigt wird; das erste gibt den anderen seine Farben: mit dem von vorn beginnen</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Add an ordinary photograph of the face (JPEG, PNG, TIFF …): from the front first, then the profiles</source>
        <translation>Ein gewöhnliches Foto des Gesichts hinzufügen (JPEG, PNG, TIFF …): erst von vorn, dann die Profile</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Take the photograph that is shown, with what was picked in it, out of this window</source>
        <translation>Das gezeigte Foto mit allem, was darin gesetzt wurde, aus diesem Fenster nehmen</translation>
    </message>
    <message>
        <source>&amp;Focal length</source>
        <translation>&amp;Brennweite</translation>
    </message>
    <message>
        <source>Of the lens, as on 35 mm film, in mm, where the camera tells it and the picture is not cropped: five landmarks are enough then, instead of six</source>
        <translation>Des Objektivs, wie auf 35-mm-Film, in mm, wo die Kamera sie nennt und das Bild nicht beschnitten ist: dann genügen fünf Landmarken statt sechs</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Click where the chosen landmark is. The wheel (or + and −) zooms, dragging moves the picture, 0 shows all of it</source>
        <translation>Klicken, wo die gewählte Landmarke ist. Das Mausrad (oder + und −) zoomt, Ziehen verschiebt das Bild, 0 zeigt es ganz</translation>
    </message>
    <message>
        <source>The photograph</source>
        <translation>Das Foto</translation>
    </message>
    <message>
        <source>Choose a landmark; click it in the photograph and on the face in the window. Left is the patient&apos;s left. What a photograph does not show is left out.</source>
        <translation>Eine Landmarke wählen; sie im Foto und auf dem Gesicht im Fenster anklicken. Links ist die linke Seite des Patienten. Was ein Foto nicht zeigt, wird ausgelassen.</translation>
    </message>
    <message>
        <source>Where each landmark is known, and how far it is from where the camera sees its place on the skin: in pixels of the photograph, and in mm on the face</source>
        <translation>Wo jede Landmarke bekannt ist, und wie weit sie davon entfernt ist, wo die Kamera ihren Ort auf der Haut sieht: in Pixeln des Fotos und in mm auf dem Gesicht</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Clear in the pho&amp;tograph</source>
        <translation>Im &amp;Foto löschen</translation>
    </message>
    <message>
        <source>Forget where the chosen landmark is in this photograph</source>
        <translation>Vergessen, wo die gewählte Landmarke in diesem Foto ist</translation>
    </message>
    <message>
        <source>Clear on the &amp;skin</source>
        <translation>Auf der Haut &amp;löschen</translation>
    </message>
    <message>
        <source>Forget where the chosen landmark is on the skin, for all photographs</source>
        <translation>Vergessen, wo die gewählte Landmarke auf der Haut ist, für alle Fotos</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop painting the skin; nothing has changed</source>
        <translation>Das Einfärben der Haut anhalten; nichts hat sich geändert</translation>
    </message>
    <message>
        <source>Pre&amp;view</source>
        <translation>&amp;Vorschau</translation>
    </message>
    <message>
        <source>Show the painted skin in the window; the plan does not change</source>
        <translation>Die gefärbte Haut im Fenster zeigen; der Plan ändert sich nicht</translation>
    </message>
    <message>
        <source>A&amp;pply…</source>
        <translation>&amp;Anwenden…</translation>
    </message>
    <message>
        <source>Write the painted skin into a new folder and take it as the case&apos;s photograph: a step that can be undone</source>
        <translation>Die gefärbte Haut in einen neuen Ordner schreiben und als Foto des Falls nehmen: ein Schritt, der sich rückgängig machen lässt</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Close this window; what was picked stays until another CT is opened</source>
        <translation>Dieses Fenster schließen; was gesetzt wurde, bleibt, bis ein anderes CT geöffnet wird</translation>
    </message>
</context>
<context>
    <name>QCoreApplication</name>
    <message>
        <source>Predicts a face after an operation on the jaw. Research use only.</source>
        <translation>Sagt ein Gesicht nach einer Kieferoperation vorher. Nur für die Forschung.</translation>
    </message>
    <message>
        <source>Print the version.</source>
        <translation>Die Version ausgeben.</translation>
    </message>
    <message>
        <source>Open the embedded demo case.</source>
        <translation>Den eingebauten Demofall öffnen.</translation>
    </message>
    <message>
        <source>A case to open (.json), or what to import as a new one: a folder with DICOM files or an image volume.</source>
        <translation>Ein Fall zum Öffnen (.json), oder was als neuer Fall importiert werden soll: ein Ordner mit DICOM-Dateien oder ein Bildvolumen.</translation>
    </message>
    <message>
        <source>more than one case; give one file, or --demo</source>
        <translation>mehr als ein Fall; geben Sie eine Datei an oder --demo</translation>
    </message>
</context>
<context>
    <name>RegionPanel</name>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Paint with the left mouse button; with Shift erase</source>
        <translation>Mit der linken Maustaste malen; mit Umschalt radieren</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>&amp;Malen</translation>
    </message>
    <message>
        <source>Erase with the left mouse button; with Shift paint</source>
        <translation>Mit der linken Maustaste radieren; mit Umschalt malen</translation>
    </message>
    <message>
        <source>Er&amp;ase</source>
        <translation>Rad&amp;ieren</translation>
    </message>
    <message>
        <source>Put the brush away: the left mouse button turns the view</source>
        <translation>Den Pinsel weglegen: die linke Maustaste dreht die Ansicht</translation>
    </message>
    <message>
        <source>Tur&amp;n view</source>
        <translation>A&amp;nsicht drehen</translation>
    </message>
    <message>
        <source>What the brush paints: the part of the face that may move, or where tissue slides over bone instead of following it, as over teeth and gums</source>
        <translation>Was der Pinsel malt: den Teil des Gesichts, der sich bewegen darf, oder wo Gewebe über Knochen gleitet, statt ihm zu folgen, wie über Zähnen und Zahnfleisch</translation>
    </message>
    <message>
        <source>Region that may move</source>
        <translation>Region, die sich bewegen darf</translation>
    </message>
    <message>
        <source>Sliding tissue (teeth, gums)</source>
        <translation>Gleitendes Gewebe (Zähne, Zahnfleisch)</translation>
    </message>
    <message>
        <source>Ra&amp;dius</source>
        <translation>Radi&amp;us</translation>
    </message>
    <message>
        <source>Radius of the brush along the skin, 1 to 40 mm (keys [ and ], Ctrl with the wheel)</source>
        <translation>Radius des Pinsels entlang der Haut, 1 bis 40 mm (Tasten [ und ], Strg mit dem Mausrad)</translation>
    </message>
    <message>
        <source>Radius of the brush along the skin, in mm (keys [ and ], Ctrl with the wheel)</source>
        <translation>Radius des Pinsels entlang der Haut, in mm (Tasten [ und ], Strg mit dem Mausrad)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Drag over the face. Shift does the opposite; [ and ] change the radius.</source>
        <translation>Über das Gesicht ziehen. Umschalt tut das Gegenteil; [ und ] ändern den Radius.</translation>
    </message>
    <message>
        <source>Change the region</source>
        <translation>Region ändern</translation>
    </message>
    <message>
        <source>Move the rim outward by this many mm</source>
        <translation>Den Rand um so viele mm nach außen rücken</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>Vergr&amp;ößern</translation>
    </message>
    <message>
        <source>Move the rim inward by this many mm</source>
        <translation>Den Rand um so viele mm nach innen rücken</translation>
    </message>
    <message>
        <source>Shrin&amp;k</source>
        <translation>V&amp;erkleinern</translation>
    </message>
    <message>
        <source>Even out bays and spikes of the rim narrower than this many mm</source>
        <translation>Buchten und Spitzen des Randes glätten, die schmaler sind als so viele mm</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>Glä&amp;tten</translation>
    </message>
    <message>
        <source>By how much the rim is moved or evened out, in mm</source>
        <translation>Um wie viel der Rand verschoben oder geglättet wird, in mm</translation>
    </message>
    <message>
        <source>Add the mirror image across the face&apos;s own midline</source>
        <translation>Das Spiegelbild an der Mittellinie des Gesichts hinzufügen</translation>
    </message>
    <message>
        <source>M&amp;irror</source>
        <translation>S&amp;piegeln</translation>
    </message>
    <message>
        <source>Keep the largest piece and fill holes of less than 2 cm²; mouth and nostrils stay open</source>
        <translation>Das größte Stück behalten und Löcher unter 2 cm² füllen; Mund und Nasenlöcher bleiben offen</translation>
    </message>
    <message>
        <source>Tid&amp;y up</source>
        <translation>&amp;Säubern</translation>
    </message>
    <message>
        <source>Erase the whole region</source>
        <translation>Die ganze Region löschen</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Take the face within this distance of the segment, in place of what is painted</source>
        <translation>Das Gesicht innerhalb dieses Abstands vom Segment nehmen, anstelle des Gemalten</translation>
    </message>
    <message>
        <source>S&amp;uggest from the segment</source>
        <translation>Aus Segment vorschla&amp;gen</translation>
    </message>
    <message>
        <source>How far from the segment the suggested region reaches, in mm</source>
        <translation>Wie weit vom Segment die vorgeschlagene Region reicht, in mm</translation>
    </message>
    <message>
        <source>Lips</source>
        <translation>Lippen</translation>
    </message>
    <message>
        <source>Click along the line between the lips, from corner to corner. Enter or this button again: done; Backspace: one click back; Escape: leave the line as it was</source>
        <translation>Entlang der Linie zwischen den Lippen klicken, von Mundwinkel zu Mundwinkel. Eingabetaste oder noch einmal dieser Knopf: fertig; Rücktaste: ein Klick zurück; Esc: die Linie lassen, wie sie war</translation>
    </message>
    <message>
        <source>&amp;Trace</source>
        <translation>Zei&amp;chnen</translation>
    </message>
    <message>
        <source>Look for the groove between the lips in the shape of the face, tied to the landmarks stomion and corners of the mouth where they are marked</source>
        <translation>Die Furche zwischen den Lippen in der Form des Gesichts suchen, gebunden an die Landmarken Stomion und Mundwinkel, wo sie markiert sind</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>Vorschlagen</translation>
    </message>
    <message>
        <source>Remove the line: the lips hang together again</source>
        <translation>Die Linie entfernen: die Lippen hängen wieder zusammen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Area of the region on the skin, in cm², and how many triangles of the face it has</source>
        <translation>Fläche der Region auf der Haut, in cm², und wie viele Dreiecke des Gesichts sie hat</translation>
    </message>
    <message>
        <source>Least distance from the held rim to moving bone, in mm: below 15 mm the face is held back</source>
        <translation>Kleinster Abstand vom gehaltenen Rand zum bewegten Knochen, in mm: unter 15 mm wird das Gesicht zurückgehalten</translation>
    </message>
    <message>
        <source>Sho&amp;w how the tissue below is held</source>
        <translation>Halt des Gewebes &amp;zeigen</translation>
    </message>
    <message>
        <source>Mark on the face how the tissue below is held at its inner side</source>
        <translation>Auf dem Gesicht markieren, wie das Gewebe darunter an seiner Innenseite gehalten wird</translation>
    </message>
    <message>
        <source>Attached to the segment</source>
        <translation>Am Segment befestigt</translation>
    </message>
    <message>
        <source>Points of the tissue that follow a moved segment</source>
        <translation>Punkte des Gewebes, die einem bewegten Segment folgen</translation>
    </message>
    <message>
        <source>Sliding over bone or teeth</source>
        <translation>Gleitend (Knochen, Zähne)</translation>
    </message>
    <message>
        <source>Points that follow bone along its normal only</source>
        <translation>Punkte, die dem Knochen nur entlang seiner Normalen folgen</translation>
    </message>
    <message>
        <source>Held by other bone or the rim</source>
        <translation>Gehalten (Knochen, Rand)</translation>
    </message>
    <message>
        <source>Points that do not move</source>
        <translation>Punkte, die sich nicht bewegen</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Points that move as the tissue pulls them</source>
        <translation>Punkte, die sich bewegen, wie das Gewebe sie zieht</translation>
    </message>
    <message>
        <source>by</source>
        <translation>um</translation>
    </message>
    <message>
        <source>Rim to segment</source>
        <translation>Rand bis Segment</translation>
    </message>
</context>
<context>
    <name>RegistrationPanel</name>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>A&amp;dd a photograph…</source>
        <translation>Foto hin&amp;zufügen…</translation>
    </message>
    <message>
        <source>&amp;Use the CT&apos;s skin</source>
        <translation>Ha&amp;ut des CT</translation>
    </message>
    <message>
        <source>Take the photograph out of the plan: the skin of the CT is the face again</source>
        <translation>Das Foto aus dem Plan nehmen: die Haut des CT ist wieder das Gesicht</translation>
    </message>
    <message>
        <source>How it lies on the CT</source>
        <translation>Wie es auf dem CT liegt</translation>
    </message>
    <message>
        <source>Distances from the photograph to the CT&apos;s skin, in mm, of what lies within 15 mm of it and faces as it does</source>
        <translation>Abstände vom Foto zur Haut des CT, in mm, für alles, was innerhalb von 15 mm liegt und in dieselbe Richtung zeigt</translation>
    </message>
    <message>
        <source>How well the photograph lies on the CT</source>
        <translation>Wie gut das Foto auf dem CT liegt</translation>
    </message>
    <message>
        <source>&amp;Accept</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>Put the photograph where it is proposed: a step that can be undone</source>
        <translation>Das Foto dorthin legen, wo es vorgeschlagen ist: ein Schritt, der sich rückgängig machen lässt</translation>
    </message>
    <message>
        <source>Re&amp;ject</source>
        <translation>V&amp;erwerfen</translation>
    </message>
    <message>
        <source>Leave the photograph where the plan has it</source>
        <translation>Das Foto dort lassen, wo der Plan es hat</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Photo&amp;graph</source>
        <translation>F&amp;oto</translation>
    </message>
    <message>
        <source>Show the photograph alone</source>
        <translation>Nur das Foto zeigen</translation>
    </message>
    <message>
        <source>CT&apos;s s&amp;kin</source>
        <translation>C&amp;T-Haut</translation>
    </message>
    <message>
        <source>Show the CT&apos;s skin alone</source>
        <translation>Nur die Haut des CT zeigen</translation>
    </message>
    <message>
        <source>Bo&amp;th</source>
        <translation>Be&amp;ides</translation>
    </message>
    <message>
        <source>The photograph coloured by its distance above (red) or below (blue) the CT&apos;s skin, in mm, with the skin as a veil</source>
        <translation>Das Foto, gefärbt nach seinem Abstand über (rot) oder unter (blau) der Haut des CT, in mm, mit der Haut als Schleier</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Fit automaticall&amp;y</source>
        <translation>Automatisch an&amp;passen</translation>
    </message>
    <message>
        <source>Find the photograph&apos;s place on the CT&apos;s skin from their shapes, wherever it lies now</source>
        <translation>Den Platz des Fotos auf der Haut des CT aus der Form beider finden, wo immer es jetzt liegt</translation>
    </message>
    <message>
        <source>&amp;Scale, too</source>
        <translation>Auch ska&amp;lieren</translation>
    </message>
    <message>
        <source>Fit the photograph&apos;s size, too: only where its unit or its camera is in doubt</source>
        <translation>Auch die Größe des Fotos anpassen: nur, wenn seine Einheit oder seine Kamera zweifelhaft ist</translation>
    </message>
    <message>
        <source>Whole face</source>
        <translation>Ganzes Gesicht</translation>
    </message>
    <message>
        <source>Refi&amp;ne</source>
        <translation>Feinanpassun&amp;g</translation>
    </message>
    <message>
        <source>Move the photograph onto the CT&apos;s skin from where it is shown; it should lie there to some 15 mm and 20°</source>
        <translation>Das Foto von dort, wo es gezeigt wird, auf die Haut des CT rücken; es sollte bis auf etwa 15 mm und 20° dort liegen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop fitting: the photograph stays where it is</source>
        <translation>Die Anpassung anhalten: das Foto bleibt, wo es ist</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>The same place picked in the photograph and on the CT; what is left between them, in mm, before the last fit and where the photograph is shown</source>
        <translation>Dieselbe Stelle, auf dem Foto und auf dem CT gesetzt; was zwischen beiden bleibt, in mm, vor der letzten Anpassung und wo das Foto gezeigt wird</translation>
    </message>
    <message>
        <source>&amp;Pick</source>
        <translation>&amp;Setzen</translation>
    </message>
    <message>
        <source>Click the chosen landmark on the surface that is shown; the next one is chosen then. Beside the face the mouse turns the view</source>
        <translation>Die gewählte Landmarke auf der gezeigten Oberfläche anklicken; danach ist die nächste gewählt. Neben dem Gesicht dreht die Maus die Ansicht</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>Lös&amp;chen</translation>
    </message>
    <message>
        <source>Forget both places of the chosen landmark</source>
        <translation>Beide Orte der gewählten Landmarke vergessen</translation>
    </message>
    <message>
        <source>F&amp;it to landmarks</source>
        <translation>An Land&amp;marken anpassen</translation>
    </message>
    <message>
        <source>Put the photograph where its landmarks come nearest to those on the CT: at least three</source>
        <translation>Das Foto dorthin legen, wo seine Landmarken denen des CT am nächsten kommen: mindestens drei</translation>
    </message>
    <message>
        <source>Move by hand</source>
        <translation>Von Hand bewegen</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>How far the photograph is moved to the front, in mm</source>
        <translation>Wie weit das Foto nach vorn verschoben ist, in mm</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Pitch</translation>
    </message>
    <message>
        <source>Turn about the left–right axis through its middle, in degrees; positive lifts the chin</source>
        <translation>Drehung um die Links-rechts-Achse durch seine Mitte, in Grad; positiv hebt das Kinn</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>How far the photograph is moved up, in mm</source>
        <translation>Wie weit das Foto nach oben verschoben ist, in mm</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Roll</translation>
    </message>
    <message>
        <source>Turn about the front–back axis, in degrees; positive lifts the patient&apos;s left side</source>
        <translation>Drehung um die Achse von vorn nach hinten, in Grad; positiv hebt die linke Seite des Patienten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>How far the photograph is moved to the patient&apos;s left, in mm</source>
        <translation>Wie weit das Foto zur linken Seite des Patienten verschoben ist, in mm</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Yaw</translation>
    </message>
    <message>
        <source>Turn about the vertical axis, in degrees; positive turns the nose to the patient&apos;s left</source>
        <translation>Drehung um die senkrechte Achse, in Grad; positiv dreht die Nase zur linken Seite des Patienten</translation>
    </message>
    <message>
        <source>Take a 3D photograph (OBJ, PLY, STL, GLB, glTF, 3DS, FBX, DAE, OFF or 3MF) as the face; its unit of length is asked for</source>
        <translation>Ein 3D-Foto (OBJ, PLY, STL, GLB, glTF, 3DS, FBX, DAE, OFF oder 3MF) als Gesicht nehmen; nach seiner Längeneinheit wird gefragt</translation>
    </message>
    <message>
        <source>Which part of the photograph decides. Forehead, brows and bridge of the nose, which are proposed, stay the same with another expression; what is painted decides an automatic fit, too</source>
        <translation>Welcher Teil des Fotos entscheidet. Stirn, Brauen und Nasenrücken, die vorgeschlagen werden, bleiben bei anderem Gesichtsausdruck gleich; was gemalt ist, entscheidet auch eine automatische Anpassung</translation>
    </message>
    <message>
        <source>Stable region</source>
        <translation>Stabile Region</translation>
    </message>
    <message>
        <source>Paint the stable region on the photograph: the part that decides the fit. Shift erases, Ctrl with the wheel changes the brush, Escape drops the stroke; beside the face the mouse turns the view</source>
        <translation>Die stabile Region auf dem Foto malen: den Teil, der die Anpassung entscheidet. Umschalt radiert, Strg mit dem Mausrad ändert den Pinsel, Esc verwirft den Strich; neben dem Gesicht dreht die Maus die Ansicht</translation>
    </message>
    <message>
        <source>Erase from the stable region, as where hair or another expression would mislead the fit. Shift paints</source>
        <translation>Aus der stabilen Region radieren, etwa wo Haare oder ein anderer Ausdruck die Anpassung irreführten. Umschalt malt</translation>
    </message>
    <message>
        <source>Take forehead, brows and bridge of the nose again, where the photograph lies</source>
        <translation>Wieder Stirn, Brauen und Nasenrücken nehmen, dort, wo das Foto liegt</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Radius of the brush along the skin, in mm</source>
        <translation>Radius des Pinsels entlang der Haut, in mm</translation>
    </message>
    <message>
        <source>Paint more</source>
        <translation>Mehr malen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>Vorschlagen</translation>
    </message>
    <message>
        <source>No 3D photograph? Give the CT&apos;s skin the colours of ordinary photographs from the front and the sides</source>
        <translation>Kein 3D-Foto? Der Haut des CT die Farben gewöhnlicher Fotos von vorn und von den Seiten geben</translation>
    </message>
    <message>
        <source>Project photographs…</source>
        <translation>Fotos projizieren…</translation>
    </message>
</context>
<context>
    <name>SeriesDialog</name>
    <message>
        <source>Import a CT</source>
        <translation>CT importieren</translation>
    </message>
    <message>
        <source>Series of the folder</source>
        <translation>Serien des Ordners</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Size, pixels</source>
        <translation>Größe, Pixel</translation>
    </message>
    <message>
        <source>Pixel, mm</source>
        <translation>Pixel, mm</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>Reading the folder…</source>
        <translation>Der Ordner wird gelesen…</translation>
    </message>
    <message>
        <source>&amp;Show descriptions (they may hold names)</source>
        <translation>&amp;Beschreibungen zeigen (können Namen enthalten)</translation>
    </message>
    <message>
        <source>Descriptions are typed by hand at the scanner and may name the patient: hidden until you ask for them. Names, dates and numbers of the patient are never shown.</source>
        <translation>Beschreibungen werden am Gerät von Hand eingegeben und können den Patienten nennen: verborgen, bis Sie danach fragen. Namen, Daten und Nummern des Patienten werden nie gezeigt.</translation>
    </message>
</context>
<context>
    <name>TissueDialog</name>
    <message>
        <source>Tissue model</source>
        <translation>Gewebemodell</translation>
    </message>
    <message>
        <source>T&amp;olerance of the face</source>
        <translation>&amp;Toleranz am Gesicht</translation>
    </message>
    <message>
        <source>How far 95 % of the face may be off by the program&apos;s own estimate, in mm: the cheapest model that keeps it is chosen</source>
        <translation>Um wie viel 95 % des Gesichts nach eigener Schätzung des Programms abweichen dürfen, in mm: das günstigste Modell, das sie einhält, wird gewählt</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Elements</source>
        <translation>&amp;Elemente</translation>
    </message>
    <message>
        <source>Automatic: linear ones where they keep the tolerance</source>
        <translation>Automatisch: lineare, wo sie die Toleranz einhalten</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>quadratic</source>
        <translation>quadratisch</translation>
    </message>
    <message>
        <source>&amp;Strain</source>
        <translation>&amp;Verzerrung</translation>
    </message>
    <message>
        <source>Automatic: small strain where it keeps the tolerance, else large strain (neo-Hookean)</source>
        <translation>Automatisch: kleine Verzerrung, wo sie die Toleranz einhält, sonst große (Neo-Hooke)</translation>
    </message>
    <message>
        <source>small (linear)</source>
        <translation>klein (linear)</translation>
    </message>
    <message>
        <source>large (neo-Hookean)</source>
        <translation>groß (Neo-Hooke)</translation>
    </message>
    <message>
        <source>&amp;Kinds of tissue</source>
        <translation>&amp;Gewebearten</translation>
    </message>
    <message>
        <source>One material everywhere, or fat, muscle and skin by the CT&apos;s Hounsfield units</source>
        <translation>Überall ein Material, oder Fett, Muskel und Haut nach den Hounsfield-Werten des CT</translation>
    </message>
    <message>
        <source>one material</source>
        <translation>ein Material</translation>
    </message>
    <message>
        <source>from the CT</source>
        <translation>aus dem CT</translation>
    </message>
    <message>
        <source>&amp;Poisson&apos;s ratio</source>
        <translation>&amp;Querkontraktionszahl</translation>
    </message>
    <message>
        <source>How little the tissue changes its volume: 0.46 is usual, 0.5 would be not at all. Young&apos;s modulus drops out where the motion of the bone is given</source>
        <translation>Wie wenig das Gewebe sein Volumen ändert: 0.46 ist üblich, 0.5 wäre gar nicht. Der Elastizitätsmodul kürzt sich heraus, wo die Bewegung des Knochens vorgegeben ist</translation>
    </message>
    <message>
        <source>&amp;Load</source>
        <translation>&amp;Belastung</translation>
    </message>
    <message>
        <source>Tissue on the segment follows it, or the force transfer of the paper</source>
        <translation>Das Gewebe am Segment folgt diesem, oder die Kraftübertragung des Fachartikels</translation>
    </message>
    <message>
        <source>follows the bone</source>
        <translation>folgt dem Knochen</translation>
    </message>
    <message>
        <source>force transfer</source>
        <translation>Kraftübertragung</translation>
    </message>
    <message>
        <source>E&amp;dges of the mesh</source>
        <translation>&amp;Kanten des Netzes</translation>
    </message>
    <message>
        <source>Length of the elements&apos; edges, in mm; automatic: 3 mm</source>
        <translation>Länge der Elementkanten, in mm; automatisch: 3 mm</translation>
    </message>
    <message>
        <source>La&amp;yers</source>
        <translation>S&amp;chichten</translation>
    </message>
    <message>
        <source>Thickness of a layer of elements, in edges; one layer: however thick the tissue is</source>
        <translation>Dicke einer Schicht von Elementen, in Kanten; eine Schicht: wie dick das Gewebe auch ist</translation>
    </message>
    <message>
        <source> edges</source>
        <translation> Kanten</translation>
    </message>
    <message>
        <source>one layer</source>
        <translation>eine Schicht</translation>
    </message>
    <message>
        <source>&amp;Reach to the bone</source>
        <translation>&amp;Reichweite zum Knochen</translation>
    </message>
    <message>
        <source>Tissue deeper than this holds to no bone, in mm</source>
        <translation>Gewebe, das tiefer liegt, hält an keinem Knochen, in mm</translation>
    </message>
    <message>
        <source>Li&amp;fted off next to a cut</source>
        <translation>&amp;Abgelöst neben einem Schnitt</translation>
    </message>
    <message>
        <source>Tissue over &amp;teeth and gums slides</source>
        <translation>Gewebe über &amp;Zähnen und Zahnfleisch gleitet</translation>
    </message>
    <message>
        <source>Mucosa slides over teeth and gums instead of following them; teeth are found by their Hounsfield units</source>
        <translation>Schleimhaut gleitet über Zähne und Zahnfleisch, statt ihnen zu folgen; Zähne werden an ihren Hounsfield-Werten erkannt</translation>
    </message>
    <message>
        <source>Bone nearer than this to a cut or to other bone does not hold tissue, in mm; less is taken on a small segment</source>
        <translation>Knochen, der näher an einem Schnitt oder an anderem Knochen liegt, hält kein Gewebe, in mm; bei einem kleinen Segment wird weniger genommen</translation>
    </message>
</context>
<context>
    <name>TurntableDialog</name>
    <message>
        <source>Export the turning face</source>
        <translation>Das sich drehende Gesicht exportieren</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Which faces turn</source>
        <translation>Welche Gesichter sich drehen</translation>
    </message>
    <message>
        <source>Before and predicted, side by side</source>
        <translation>Vorher und Vorhersage, nebeneinander</translation>
    </message>
    <message>
        <source>Predicted face</source>
        <translation>Vorhergesagtes Gesicht</translation>
    </message>
    <message>
        <source>&amp;As</source>
        <translation>&amp;Als</translation>
    </message>
    <message>
        <source>A film (Motion JPEG), or a new folder with a PNG picture for each step</source>
        <translation>Ein Film (Motion JPEG) oder ein neuer Ordner mit einem PNG-Bild für jeden Schritt</translation>
    </message>
    <message>
        <source>Film (AVI)</source>
        <translation>Film (AVI)</translation>
    </message>
    <message>
        <source>Folder of pictures (PNG)</source>
        <translation>Ordner mit Bildern (PNG)</translation>
    </message>
    <message>
        <source>&amp;Pictures</source>
        <translation>&amp;Bilder</translation>
    </message>
    <message>
        <source>How many pictures the whole turn of 360° has</source>
        <translation>Wie viele Bilder die ganze Drehung von 360° hat</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Width and height of a face&apos;s picture in pixels</source>
        <translation>Breite und Höhe des Bildes eines Gesichts in Pixeln</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> Pixel</translation>
    </message>
    <message>
        <source>&amp;Into</source>
        <translation>&amp;Nach</translation>
    </message>
    <message>
        <source>The new file or folder</source>
        <translation>Die neue Datei oder der neue Ordner</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
</context>
<context>
    <name>ViewGrid</name>
    <message>
        <source>Which Hounsfield units the greys of the slices show. By hand: drag in a slice with the right button (right: wider, up: higher), or Ctrl and the arrow keys</source>
        <translation>Welche Hounsfield-Werte die Grautöne der Schichten zeigen. Von Hand: mit der rechten Taste in einer Schicht ziehen (rechts: breiter, oben: höher), oder Strg und die Pfeiltasten</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Axial slice</source>
        <translation>Axiale Schicht</translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation>Koronale Schicht</translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation>Sagittale Schicht</translation>
    </message>
</context>
<context>
    <name>WelcomePage</name>
    <message>
        <source>&lt;h1&gt;Gnathion&lt;/h1&gt;&lt;p&gt;Move a jaw segment and see the face follow.&lt;/p&gt;</source>
        <translation>&lt;h1&gt;Gnathion&lt;/h1&gt;&lt;p&gt;Ein Kiefersegment bewegen und sehen, wie das Gesicht folgt.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Not saved when Gnathion ended unexpectedly</source>
        <translation>Nicht gespeichert, als Gnathion unerwartet endete</translation>
    </message>
    <message>
        <source>Cases that were not saved</source>
        <translation>Fälle, die nicht gespeichert wurden</translation>
    </message>
    <message>
        <source>Cases that were changed and not saved when their window ended</source>
        <translation>Fälle, die geändert und nicht gespeichert waren, als ihr Fenster endete</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>W&amp;iederherstellen</translation>
    </message>
    <message>
        <source>Open the chosen case as it was last kept, not saved yet</source>
        <translation>Den gewählten Fall öffnen, wie er zuletzt gesichert wurde, noch nicht gespeichert</translation>
    </message>
    <message>
        <source>D&amp;iscard</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>Delete what was kept of the chosen case; a file that you saved stays as it is</source>
        <translation>Die Sicherung des gewählten Falls löschen; eine Datei, die Sie gespeichert haben, bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Open the &amp;demo case</source>
        <translation>Demofall &amp;öffnen</translation>
    </message>
    <message>
        <source>A synthetic head with its mandible 6 mm forward (Ctrl+D)</source>
        <translation>Ein synthetischer Kopf mit um 6 mm vorverlagertem Unterkiefer (Strg+D)</translation>
    </message>
    <message>
        <source>Ope&amp;n a case…</source>
        <translation>Fall öff&amp;nen…</translation>
    </message>
    <message>
        <source>A case file that was saved (Ctrl+O)</source>
        <translation>Eine gespeicherte Falldatei (Strg+O)</translation>
    </message>
    <message>
        <source>I&amp;mport a CT…</source>
        <translation>CT i&amp;mportieren…</translation>
    </message>
    <message>
        <source>A new case from a folder with DICOM files, or from an image volume in Hounsfield units</source>
        <translation>Ein neuer Fall aus einem Ordner mit DICOM-Dateien oder aus einem Bildvolumen in Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>Recent cases</source>
        <translation>Zuletzt geöffnete Fälle</translation>
    </message>
    <message>
        <source>O&amp;pen</source>
        <translation>Öffn&amp;en</translation>
    </message>
    <message>
        <source>Open the chosen case</source>
        <translation>Den gewählten Fall öffnen</translation>
    </message>
    <message>
        <source>For&amp;get</source>
        <translation>Ver&amp;gessen</translation>
    </message>
    <message>
        <source>Take the chosen case out of this list, as where its path carries a patient&apos;s name; the file stays</source>
        <translation>Den gewählten Fall aus dieser Liste nehmen, etwa weil sein Pfad den Namen eines Patienten trägt; die Datei bleibt</translation>
    </message>
    <message>
        <source>C&amp;lear list</source>
        <translation>&amp;Liste leeren</translation>
    </message>
    <message>
        <source>Take all cases out of this list; the files stay</source>
        <translation>Alle Fälle aus dieser Liste nehmen; die Dateien bleiben</translation>
    </message>
    <message>
        <source>For research only. Not a medical device: not for decisions about a patient&apos;s treatment.</source>
        <translation>Nur für die Forschung. Kein Medizinprodukt: nicht für Entscheidungen über die Behandlung eines Patienten.</translation>
    </message>
    <message>
        <source>Or drop here a folder with DICOM files, an image volume
(.mha, .mhd, .nrrd, .nhdr, .nii, .nii.gz) or a case (.json);
a face scan (.obj, .ply, .stl, .glb …) on the case that it belongs to</source>
        <translation>Oder hierher ziehen: einen Ordner mit DICOM-Dateien, ein Bildvolumen
(.mha, .mhd, .nrrd, .nhdr, .nii, .nii.gz) oder einen Fall (.json);
eine Gesichtsaufnahme (.obj, .ply, .stl, .glb …) auf den Fall, zu dem sie gehört</translation>
    </message>
</context>
<context>
    <name>answer</name>
    <message>
        <source>neo-Hookean model on quadratic elements</source>
        <translation>Neo-Hooke-Modell auf quadratischen Elementen</translation>
    </message>
    <message>
        <source>neo-Hookean model on linear elements</source>
        <translation>Neo-Hooke-Modell auf linearen Elementen</translation>
    </message>
    <message>
        <source>linear model on quadratic elements</source>
        <translation>lineares Modell auf quadratischen Elementen</translation>
    </message>
    <message>
        <source>linear model on linear elements</source>
        <translation>lineares Modell auf linearen Elementen</translation>
    </message>
    <message>
        <source>estimated error %1</source>
        <translation>geschätzter Fehler %1</translation>
    </message>
    <message>
        <source> on 95 % of the face</source>
        <translation> auf 95 % des Gesichts</translation>
    </message>
    <message>
        <source>, above the tolerance</source>
        <translation>, über der Toleranz</translation>
    </message>
    <message>
        <source>, above the tolerance of %1</source>
        <translation>, über der Toleranz von %1</translation>
    </message>
    <message>
        <source>The quick answer shown while dragging differs by %1 on 95 % of the face.</source>
        <translation>Die schnelle Antwort, die beim Ziehen gezeigt wird, weicht auf 95 % des Gesichts um %1 ab.</translation>
    </message>
    <message>
        <source>%1 tetrahedra are turned inside out</source>
        <translation>%1 Tetraeder sind umgestülpt</translation>
    </message>
    <message>
        <source>%1 tetrahedra, relative residual of the linear solution %2.</source>
        <translation>%1 Tetraeder, relatives Residuum der linearen Lösung %2.</translation>
    </message>
    <message>
        <source>The face cannot follow: %1</source>
        <translation>Das Gesicht kann nicht folgen: %1</translation>
    </message>
    <message>
        <source>Nothing is cut yet: the step Bone makes a segment that can move</source>
        <translation>Noch ist nichts gesägt: der Schritt Knochen macht ein Segment, das sich bewegen kann</translation>
    </message>
    <message>
        <source>quick answer, %1</source>
        <translation>schnelle Antwort, %1</translation>
    </message>
    <message>
        <source>Its error is estimated, and a better model asked, when the motion rests.</source>
        <translation>Ihr Fehler wird geschätzt und ein besseres Modell gefragt, wenn die Bewegung ruht.</translation>
    </message>
    <message>
        <source>, being refined</source>
        <translation>, wird verfeinert</translation>
    </message>
    <message>
        <source>Its error is estimated, and a better model asked.</source>
        <translation>Ihr Fehler wird geschätzt und ein besseres Modell gefragt.</translation>
    </message>
    <message>
        <source>, not refined</source>
        <translation>, nicht verfeinert</translation>
    </message>
    <message>
        <source>The refinement failed, see the message; the error of what is shown is not known.</source>
        <translation>Die Verfeinerung ist fehlgeschlagen, siehe Meldung; der Fehler des Gezeigten ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The refinement was cancelled; the error of what is shown is not known. It begins again with the next motion.</source>
        <translation>Die Verfeinerung wurde abgebrochen; der Fehler des Gezeigten ist nicht bekannt. Mit der nächsten Bewegung beginnt sie von vorn.</translation>
    </message>
    <message>
        <source>Before any cut</source>
        <translation>Vor jedem Schnitt</translation>
    </message>
    <message>
        <source>Predicted: %1</source>
        <translation>Vorhersage: %1</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>read DICOM series</source>
        <translation>DICOM-Serie lesen</translation>
    </message>
    <message>
        <source>read volume file</source>
        <translation>Bildvolumen lesen</translation>
    </message>
    <message>
        <source>bone surface</source>
        <translation>Knochenoberfläche</translation>
    </message>
    <message>
        <source>skin surface</source>
        <translation>Hautoberfläche</translation>
    </message>
    <message>
        <source>read photograph</source>
        <translation>Foto lesen</translation>
    </message>
    <message>
        <source>look at the scan</source>
        <translation>Aufnahme prüfen</translation>
    </message>
    <message>
        <source>register photograph</source>
        <translation>Foto anpassen</translation>
    </message>
    <message>
        <source>find the photograph&apos;s place</source>
        <translation>Platz des Fotos suchen</translation>
    </message>
    <message>
        <source>the CT&apos;s skin</source>
        <translation>Haut des CT</translation>
    </message>
    <message>
        <source>fitting the photograph</source>
        <translation>Foto anpassen</translation>
    </message>
    <message>
        <source>place the cut</source>
        <translation>Schnitt setzen</translation>
    </message>
    <message>
        <source>osteotomy</source>
        <translation>Osteotomie</translation>
    </message>
    <message>
        <source>search trees</source>
        <translation>Suchbäume</translation>
    </message>
    <message>
        <source>region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>bone below the face</source>
        <translation>Knochen unter dem Gesicht</translation>
    </message>
    <message>
        <source>ST Generator</source>
        <translation>ST-Generator</translation>
    </message>
    <message>
        <source>bone map</source>
        <translation>Zuordnung zum Knochen</translation>
    </message>
    <message>
        <source>tissue from the CT</source>
        <translation>Gewebe aus dem CT</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>Halt des Gewebes</translation>
    </message>
    <message>
        <source>assemble stiffness</source>
        <translation>Steifigkeit aufstellen</translation>
    </message>
    <message>
        <source>factorise</source>
        <translation>Gleichungen zerlegen</translation>
    </message>
    <message>
        <source>response basis</source>
        <translation>Antworten auf Bewegungen</translation>
    </message>
    <message>
        <source>response basis on quadratic elements</source>
        <translation>Antworten auf Bewegungen, quadratische Elemente</translation>
    </message>
    <message>
        <source>bones for quick frames</source>
        <translation>vereinfachte Knochen</translation>
    </message>
    <message>
        <source>predict and check</source>
        <translation>Vorhersagen und prüfen</translation>
    </message>
    <message>
        <source>estimate the error</source>
        <translation>Fehler schätzen</translation>
    </message>
    <message>
        <source>quadratic elements for the error</source>
        <translation>quadratische Elemente für den Fehler</translation>
    </message>
    <message>
        <source>large strain</source>
        <translation>große Verzerrung</translation>
    </message>
    <message>
        <source>neo-Hookean</source>
        <translation>Neo-Hooke-Modell</translation>
    </message>
    <message>
        <source>damped motion</source>
        <translation>gedämpfte Bewegung</translation>
    </message>
    <message>
        <source>export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>bones as STL</source>
        <translation>Knochen als STL</translation>
    </message>
    <message>
        <source>default case</source>
        <translation>Demofall</translation>
    </message>
    <message>
        <source>phantom CT</source>
        <translation>CT des Demofalls</translation>
    </message>
    <message>
        <source>phantom DICOM</source>
        <translation>DICOM-Dateien des Demofalls</translation>
    </message>
    <message>
        <source>phantom photograph</source>
        <translation>Foto des Demofalls</translation>
    </message>
    <message>
        <source>phantom texture</source>
        <translation>Textur des Demofalls</translation>
    </message>
    <message>
        <source>chin</source>
        <translation>Kinnsegment</translation>
    </message>
    <message>
        <source>mandible body</source>
        <translation>Unterkieferkörper</translation>
    </message>
    <message>
        <source>maxilla</source>
        <translation>Oberkiefer</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>pogonion soft</source>
        <translation>Weichteil-Pogonion</translation>
    </message>
    <message>
        <source>menton soft</source>
        <translation>Weichteil-Menton</translation>
    </message>
    <message>
        <source>nasion soft</source>
        <translation>Weichteil-Nasion</translation>
    </message>
    <message>
        <source>mentolabial fold</source>
        <translation>Mentolabialfalte</translation>
    </message>
    <message>
        <source>lower lip</source>
        <translation>Unterlippe</translation>
    </message>
    <message>
        <source>upper lip</source>
        <translation>Oberlippe</translation>
    </message>
    <message>
        <source>stomion</source>
        <translation>Stomion</translation>
    </message>
    <message>
        <source>mouth corner left</source>
        <translation>linker Mundwinkel</translation>
    </message>
    <message>
        <source>mouth corner right</source>
        <translation>rechter Mundwinkel</translation>
    </message>
    <message>
        <source>subnasale</source>
        <translation>Subnasale</translation>
    </message>
    <message>
        <source>nose tip</source>
        <translation>Nasenspitze</translation>
    </message>
    <message>
        <source>linear model on %1 linear tetrahedra, estimated error %2 on 95 % of the face (tolerance %3)</source>
        <translation>lineares Modell auf %1 linearen Tetraedern, geschätzter Fehler %2 auf 95 % des Gesichts (Toleranz %3)</translation>
    </message>
    <message>
        <source>linear model on %1 quadratic tetrahedra, estimated error %2 on 95 % of the face (tolerance %3)</source>
        <translation>lineares Modell auf %1 quadratischen Tetraedern, geschätzter Fehler %2 auf 95 % des Gesichts (Toleranz %3)</translation>
    </message>
    <message>
        <source>neo-Hookean model on %1 linear tetrahedra, estimated error %2 on 95 % of the face (tolerance %3)</source>
        <translation>Neo-Hooke-Modell auf %1 linearen Tetraedern, geschätzter Fehler %2 auf 95 % des Gesichts (Toleranz %3)</translation>
    </message>
    <message>
        <source>neo-Hookean model on %1 quadratic tetrahedra, estimated error %2 on 95 % of the face (tolerance %3)</source>
        <translation>Neo-Hooke-Modell auf %1 quadratischen Tetraedern, geschätzter Fehler %2 auf 95 % des Gesichts (Toleranz %3)</translation>
    </message>
    <message>
        <source>the error of elements is not estimated for force transfer</source>
        <translation>der Fehler der Elemente wird bei Kraftübertragung nicht geschätzt</translation>
    </message>
    <message>
        <source>the linear model on linear ones would be off by %1 (elements) and %2 (small strain)</source>
        <translation>das lineare Modell auf linearen läge um %1 (Elemente) und %2 (kleine Verzerrung) daneben</translation>
    </message>
    <message>
        <source>large strain could not follow the motion: %1</source>
        <translation>große Verzerrung konnte der Bewegung nicht folgen: %1</translation>
    </message>
    <message>
        <source>on a finer mesh: %1</source>
        <translation>auf einem feineren Netz: %1</translation>
    </message>
    <message>
        <source>the case or the program allows no better model</source>
        <translation>der Fall oder das Programm lässt kein besseres Modell zu</translation>
    </message>
    <message>
        <source>the tissue could follow only %1 % of the motion: beyond, tet %2 near (%3) mm is compressed to %4 % of its volume</source>
        <translation>das Gewebe konnte nur %1 % der Bewegung folgen: danach wird Tetraeder %2 bei (%3) mm auf %4 % seines Volumens gedrückt</translation>
    </message>
    <message>
        <source>the tissue could follow only %1 % of the motion: beyond, tet %2 near (%3) mm is turned inside out</source>
        <translation>das Gewebe konnte nur %1 % der Bewegung folgen: danach stülpt sich Tetraeder %2 bei (%3) mm um</translation>
    </message>
    <message>
        <source>move the bone less, or choose a region with more free tissue around the bone</source>
        <translation>den Knochen weniger bewegen oder eine Region mit mehr freiem Gewebe um den Knochen wählen</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>the blade does not touch the bone</source>
        <translation>das Sägeblatt berührt den Knochen nicht</translation>
    </message>
    <message>
        <source>the box does not touch the bone</source>
        <translation>der Quader berührt den Knochen nicht</translation>
    </message>
    <message>
        <source>move it onto the bone</source>
        <translation>auf den Knochen schieben</translation>
    </message>
    <message>
        <source>the box holds too little bone to be moved</source>
        <translation>im Quader ist zu wenig Knochen zum Bewegen</translation>
    </message>
    <message>
        <source>the piece to take is too small to be moved</source>
        <translation>das Stück ist zu klein zum Bewegen</translation>
    </message>
    <message>
        <source>enlarge the box or move it so that the segment lies in it</source>
        <translation>den Quader vergrößern oder so verschieben, dass das Segment darin liegt</translation>
    </message>
    <message>
        <source>move the blade deeper into the bone</source>
        <translation>das Sägeblatt tiefer in den Knochen schieben</translation>
    </message>
    <message>
        <source>the blade passes through, but nothing comes apart</source>
        <translation>das Sägeblatt geht hindurch, aber nichts löst sich</translation>
    </message>
    <message>
        <source>move or turn the blade so that it parts the bone in two</source>
        <translation>das Sägeblatt so verschieben oder drehen, dass es den Knochen in zwei Stücke teilt</translation>
    </message>
    <message>
        <source>the blade does not pass through the whole bone: it ends within it, and nothing comes apart</source>
        <translation>das Sägeblatt geht nicht durch den ganzen Knochen: es endet darin, und nichts löst sich</translation>
    </message>
    <message>
        <source>enlarge the blade</source>
        <translation>das Sägeblatt vergrößern</translation>
    </message>
    <message>
        <source>enlarge the blade or move it %1</source>
        <translation>das Sägeblatt vergrößern oder %1 verschieben</translation>
    </message>
    <message>
        <source>to the patient&apos;s right</source>
        <translation>zur rechten Seite des Patienten</translation>
    </message>
    <message>
        <source>to the patient&apos;s left</source>
        <translation>zur linken Seite des Patienten</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>nach vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>nach hinten</translation>
    </message>
    <message>
        <source>down</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>the blade also cuts bone that does not belong to the segment: %1 cm² %2 it</source>
        <translation>das Sägeblatt schneidet auch Knochen, der nicht zum Segment gehört: %1 cm² %2</translation>
    </message>
    <message>
        <source>the box also cuts bone that does not belong to the segment: %1 cm³ %2 it</source>
        <translation>der Quader schneidet auch Knochen, der nicht zum Segment gehört: %1 cm³ %2</translation>
    </message>
    <message>
        <source>on the patient&apos;s right of</source>
        <translation>rechts davon (vom Patienten aus)</translation>
    </message>
    <message>
        <source>on the patient&apos;s left of</source>
        <translation>links davon (vom Patienten aus)</translation>
    </message>
    <message>
        <source>in front of</source>
        <translation>davor</translation>
    </message>
    <message>
        <source>behind</source>
        <translation>dahinter</translation>
    </message>
    <message>
        <source>below</source>
        <translation>darunter</translation>
    </message>
    <message>
        <source>above</source>
        <translation>darüber</translation>
    </message>
    <message>
        <source>make the blade smaller on that side, or move or turn it</source>
        <translation>das Sägeblatt auf dieser Seite verkleinern, verschieben oder drehen</translation>
    </message>
    <message>
        <source>make the box smaller on that side, or move or turn it</source>
        <translation>den Quader auf dieser Seite verkleinern, verschieben oder drehen</translation>
    </message>
    <message>
        <source>no such cut was found on this bone: %1</source>
        <translation>ein solcher Schnitt wurde an diesem Knochen nicht gefunden: %1</translation>
    </message>
    <message>
        <source>place a blade or a box by hand</source>
        <translation>ein Sägeblatt oder einen Quader von Hand setzen</translation>
    </message>
    <message>
        <source>the chin was not found on the bone</source>
        <translation>das Kinn wurde am Knochen nicht gefunden</translation>
    </message>
    <message>
        <source>the bite was not found on the bone</source>
        <translation>die Okklusionsebene wurde am Knochen nicht gefunden</translation>
    </message>
    <message>
        <source>a jaw was not found on the bone</source>
        <translation>ein Kiefer wurde am Knochen nicht gefunden</translation>
    </message>
    <message>
        <source>choose another HU level</source>
        <translation>eine andere HU-Schwelle wählen</translation>
    </message>
    <message>
        <source>give the landmark &quot;stomion&quot; on the skin, or place a box by hand</source>
        <translation>die Landmarke „stomion“ auf der Haut angeben oder einen Quader von Hand setzen</translation>
    </message>
    <message>
        <source>segment empty after the cut: the largest piece of bone in the box has %1 mm3</source>
        <translation>nach dem Schnitt ist das Segment leer: das größte Knochenstück im Quader hat %1 mm³</translation>
    </message>
    <message>
        <source>move or enlarge the box so that the jaw lies in it (LPS mm)</source>
        <translation>den Quader so verschieben oder vergrößern, dass der Kiefer darin liegt (LPS, mm)</translation>
    </message>
    <message>
        <source>segment empty after the cut: the piece at the seed has %1 mm3</source>
        <translation>nach dem Schnitt ist das Segment leer: das Stück am Saatpunkt hat %1 mm³</translation>
    </message>
    <message>
        <source>move the seed into the piece to take, or move the plate</source>
        <translation>den Saatpunkt in das gewünschte Stück setzen oder das Sägeblatt verschieben</translation>
    </message>
    <message>
        <source>the plate does not touch the bone</source>
        <translation>das Sägeblatt berührt den Knochen nicht</translation>
    </message>
    <message>
        <source>the plate is too small to separate anything: the bone at the seed stays in one piece</source>
        <translation>das Sägeblatt ist zu klein, um etwas zu trennen: der Knochen am Saatpunkt bleibt in einem Stück</translation>
    </message>
    <message>
        <source>enlarge the plate or move it so that it passes right through the jaw</source>
        <translation>das Sägeblatt vergrößern oder so verschieben, dass es ganz durch den Kiefer geht</translation>
    </message>
    <message>
        <source>the bone surface cuts itself where the osteotomy goes</source>
        <translation>die Knochenoberfläche durchdringt sich selbst, wo die Osteotomie verläuft</translation>
    </message>
    <message>
        <source>make the bone surface again from the CT, at another HU level</source>
        <translation>die Knochenoberfläche mit einer anderen HU-Schwelle neu aus dem CT bilden</translation>
    </message>
    <message>
        <source>the cut would leave a surface that is no two-manifold</source>
        <translation>der Schnitt ließe eine Oberfläche zurück, die keine Mannigfaltigkeit ist</translation>
    </message>
    <message>
        <source>move or turn the cut a little</source>
        <translation>den Schnitt etwas verschieben oder drehen</translation>
    </message>
    <message>
        <source>condyles</source>
        <translation>Kondylen</translation>
    </message>
    <message>
        <source>there is no bone</source>
        <translation>es gibt keinen Knochen</translation>
    </message>
    <message>
        <source>the lower jaw has one side only</source>
        <translation>der Unterkiefer hat nur eine Seite</translation>
    </message>
    <message>
        <source>the ends of this piece of bone do not lie as two condyles do</source>
        <translation>die Enden dieses Knochenstücks liegen nicht wie zwei Kondylen</translation>
    </message>
    <message>
        <source>the lower jaw and the skull are one piece at this bone level</source>
        <translation>Unterkiefer und Schädel sind bei dieser Knochenschwelle ein Stück</translation>
    </message>
    <message>
        <source>the CT ends below the condyles</source>
        <translation>das CT endet unterhalb der Kondylen</translation>
    </message>
    <message>
        <source>type two points of the hinge axis, or choose a bone level (HU) at which the lower jaw stands alone and a CT that holds both joints</source>
        <translation>zwei Punkte der Scharnierachse eingeben, oder eine Knochenschwelle (HU) wählen, bei der der Unterkiefer allein steht, und ein CT, das beide Gelenke enthält</translation>
    </message>
    <message>
        <source>all of it was erased</source>
        <translation>sie wurde ganz gelöscht</translation>
    </message>
    <message>
        <source>paint the part of the face that may move, or take the suggested one</source>
        <translation>den Teil des Gesichts malen, der sich bewegen darf, oder den vorgeschlagenen nehmen</translation>
    </message>
    <message>
        <source>no bone of a segment lies under it, so nothing would move the face</source>
        <translation>kein Knochen eines Segments liegt darunter, so dass nichts das Gesicht bewegte</translation>
    </message>
    <message>
        <source>choose a region over the segment, or raise tissue.bone_reach_mm</source>
        <translation>eine Region über dem Segment wählen oder im Gewebemodell „Reichweite zum Knochen“ erhöhen (tissue.bone_reach_mm)</translation>
    </message>
    <message>
        <source>it has no rim: the whole surface was chosen, so nothing would hold the face</source>
        <translation>sie hat keinen Rand: die ganze Oberfläche wurde gewählt, so dass nichts das Gesicht hielte</translation>
    </message>
    <message>
        <source>choose a smaller region (region.reach_mm, or fewer vertices)</source>
        <translation>eine kleinere Region wählen (region.reach_mm oder weniger Punkte)</translation>
    </message>
    <message>
        <source>no part of the face is within %1 mm of the bone segment</source>
        <translation>kein Teil des Gesichts liegt innerhalb von %1 mm um das Knochensegment</translation>
    </message>
    <message>
        <source>check the photograph&apos;s transform and unit, or raise region.reach_mm</source>
        <translation>Lage und Einheit des Fotos prüfen oder region.reach_mm erhöhen</translation>
    </message>
    <message>
        <source>it is in %1 pieces</source>
        <translation>sie besteht aus %1 Stücken</translation>
    </message>
    <message>
        <source>choose one connected region around the segment</source>
        <translation>eine zusammenhängende Region um das Segment wählen</translation>
    </message>
    <message>
        <source>its vertices span no triangle of the face</source>
        <translation>ihre Punkte spannen kein Dreieck des Gesichts auf</translation>
    </message>
    <message>
        <source>choose a patch of neighbouring vertices</source>
        <translation>ein Stück aus benachbarten Punkten wählen</translation>
    </message>
    <message>
        <source>its surface touches itself at a vertex of triangle %1</source>
        <translation>ihre Oberfläche berührt sich selbst an einer Ecke von Dreieck %1</translation>
    </message>
    <message>
        <source>choose a region without pieces that hang together by a corner only</source>
        <translation>eine Region ohne Stücke wählen, die nur an einer Ecke zusammenhängen</translation>
    </message>
    <message>
        <source>only %1 triangles are left at edges of %2 mm</source>
        <translation>nur %1 Dreiecke bleiben bei Kanten von %2 mm</translation>
    </message>
    <message>
        <source>ask for shorter edges, or choose a larger region</source>
        <translation>kürzere Kanten oder eine größere Region wählen</translation>
    </message>
    <message>
        <source>no point of the tissue is fixed or attached</source>
        <translation>kein Punkt des Gewebes ist fest oder befestigt</translation>
    </message>
    <message>
        <source>choose a region with a rim, so that the face does not float</source>
        <translation>eine Region mit Rand wählen, damit das Gesicht nicht schwebt</translation>
    </message>
    <message>
        <source>the two sides of the face are too different to be mirrored</source>
        <translation>die beiden Seiten des Gesichts sind zu verschieden, um gespiegelt zu werden</translation>
    </message>
    <message>
        <source>paint the other side by hand, or check that the photograph stands upright in the patient&apos;s frame</source>
        <translation>die andere Seite von Hand malen, oder prüfen, ob das Foto im Patientensystem aufrecht steht</translation>
    </message>
    <message>
        <source>it has fewer than two points</source>
        <translation>sie hat weniger als zwei Punkte</translation>
    </message>
    <message>
        <source>trace it from corner to corner</source>
        <translation>sie von Mundwinkel zu Mundwinkel zeichnen</translation>
    </message>
    <message>
        <source>it leaves the region at %1</source>
        <translation>sie verlässt die Region bei %1</translation>
    </message>
    <message>
        <source>trace it on the skin, with more points where the lips curve, or paint the region there; where the mouth of the scan is open, no line is needed</source>
        <translation>sie auf der Haut zeichnen, mit mehr Punkten, wo die Lippen gebogen sind, oder dort die Region malen; wo der Mund der Aufnahme offen ist, braucht es keine Linie</translation>
    </message>
    <message>
        <source>it ends at the region&apos;s rim, at %1</source>
        <translation>sie endet am Rand der Region, bei %1</translation>
    </message>
    <message>
        <source>end it at the corner of the mouth, or paint a larger region</source>
        <translation>sie am Mundwinkel enden lassen oder eine größere Region malen</translation>
    </message>
    <message>
        <source>it crosses the region&apos;s rim, so that no way along the region follows it</source>
        <translation>sie kreuzt den Rand der Region, so dass kein Weg in der Region ihr folgt</translation>
    </message>
    <message>
        <source>trace it where the lips are joined; where the mouth of the scan is open, no line is needed</source>
        <translation>sie zeichnen, wo die Lippen verbunden sind; wo der Mund der Aufnahme offen ist, braucht es keine Linie</translation>
    </message>
    <message>
        <source>it is too short: it spans %1 edges of the region</source>
        <translation>sie ist zu kurz: sie geht über %1 Kanten der Region</translation>
    </message>
    <message>
        <source>trace it from one corner of the mouth to the other, or remove it</source>
        <translation>sie von einem Mundwinkel zum anderen zeichnen oder entfernen</translation>
    </message>
    <message>
        <source>The profile does not show nose, lips and chin clearly.</source>
        <translation>Das Profil zeigt Nase, Lippen und Kinn nicht deutlich.</translation>
    </message>
    <message>
        <source>The corners of the mouth are not marked as landmarks; the line ends where the groove between the lips fades.</source>
        <translation>Die Mundwinkel sind nicht als Landmarken markiert; die Linie endet, wo die Furche zwischen den Lippen ausläuft.</translation>
    </message>
    <message>
        <source>Its two halves are not equally long.</source>
        <translation>Ihre beiden Hälften sind nicht gleich lang.</translation>
    </message>
    <message>
        <source>There is no face.</source>
        <translation>Es gibt kein Gesicht.</translation>
    </message>
    <message>
        <source>No mouth was found below the tip of the nose.</source>
        <translation>Unter der Nasenspitze wurde kein Mund gefunden.</translation>
    </message>
    <message>
        <source>There is no face at the mouth&apos;s landmarks.</source>
        <translation>An den Landmarken des Mundes ist kein Gesicht.</translation>
    </message>
    <message>
        <source>The groove between the lips hardly shows in the shape.</source>
        <translation>Die Furche zwischen den Lippen ist in der Form kaum zu sehen.</translation>
    </message>
    <message>
        <source>only %1 % of the stable region lies near the CT&apos;s skin</source>
        <translation>nur %1 % der stabilen Region liegen nahe der Haut des CT</translation>
    </message>
    <message>
        <source>only %1 cm² of the photograph lie on the CT&apos;s skin</source>
        <translation>nur %1 cm² des Fotos liegen auf der Haut des CT</translation>
    </message>
    <message>
        <source>only %1 % of the photograph near the CT&apos;s skin lies on it</source>
        <translation>nur %1 % des Fotos nahe der Haut des CT liegen auf ihr</translation>
    </message>
    <message>
        <source>pick landmarks, or check the photograph&apos;s unit</source>
        <translation>Landmarken setzen oder die Einheit des Fotos prüfen</translation>
    </message>
    <message>
        <source>the fit has not come to rest after %1 steps</source>
        <translation>die Anpassung ist nach %1 Schritten nicht zur Ruhe gekommen</translation>
    </message>
    <message>
        <source>begin nearer, from landmarks</source>
        <translation>näher beginnen, von Landmarken aus</translation>
    </message>
    <message>
        <source>the surfaces lie %1 mm apart where they fit best: another person, another expression or another scale</source>
        <translation>die Oberflächen liegen dort, wo sie am besten passen, %1 mm auseinander: eine andere Person, ein anderer Ausdruck oder ein anderer Maßstab</translation>
    </message>
    <message>
        <source>look at the colour map</source>
        <translation>die Farbkarte ansehen</translation>
    </message>
    <message>
        <source>the part that decides is as smooth as a ball and could slide</source>
        <translation>der entscheidende Teil ist glatt wie eine Kugel und könnte verrutschen</translation>
    </message>
    <message>
        <source>paint more of the nose and the brows as stable, or pick landmarks</source>
        <translation>mehr von Nase und Brauen als stabil malen oder Landmarken setzen</translation>
    </message>
    <message>
        <source>the landmarks are %1 mm apart (RMS) where the surfaces fit</source>
        <translation>die Landmarken liegen %1 mm auseinander (RMS), wo die Oberflächen passen</translation>
    </message>
    <message>
        <source>look for one that was picked elsewhere, or begin from the landmarks</source>
        <translation>eine suchen, die anderswo gesetzt wurde, oder von den Landmarken aus beginnen</translation>
    </message>
    <message>
        <source>upper and lower face do not fit together (%1 mm), as with another expression</source>
        <translation>oberes und unteres Gesicht passen nicht zusammen (%1 mm), wie bei einem anderen Ausdruck</translation>
    </message>
    <message>
        <source>look whether forehead and nose fit, and paint them as stable</source>
        <translation>prüfen, ob Stirn und Nase passen, und sie als stabil malen</translation>
    </message>
    <message>
        <source>nothing of the photograph&apos;s shape is like the CT&apos;s face</source>
        <translation>nichts an der Form des Fotos gleicht dem Gesicht des CT</translation>
    </message>
    <message>
        <source>pick landmarks</source>
        <translation>Landmarken setzen</translation>
    </message>
    <message>
        <source>it fits elsewhere nearly as well</source>
        <translation>es passt anderswo fast ebenso gut</translation>
    </message>
    <message>
        <source>pick landmarks to say where it belongs</source>
        <translation>mit Landmarken sagen, wohin es gehört</translation>
    </message>
    <message>
        <source>the fit has moved the face %1 mm from its start</source>
        <translation>die Anpassung hat das Gesicht um %1 mm von seinem Anfang bewegt</translation>
    </message>
    <message>
        <source>look whether it slid, or let it be found from shape alone</source>
        <translation>prüfen, ob es verrutscht ist, oder es allein aus der Form finden lassen</translation>
    </message>
    <message>
        <source>the photograph is in no usual unit: %1 mm a unit were estimated from its shape</source>
        <translation>das Foto ist in keiner üblichen Einheit: %1 mm je Einheit wurden aus seiner Form geschätzt</translation>
    </message>
    <message>
        <source>measure it, or give the scale</source>
        <translation>es ausmessen oder den Maßstab angeben</translation>
    </message>
    <message>
        <source>in no usual unit is the scan as large as a head; with %1 mm a unit its longest side is that of one</source>
        <translation>in keiner üblichen Einheit ist die Aufnahme so groß wie ein Kopf; mit %1 mm je Einheit ist ihre längste Seite die eines Kopfes</translation>
    </message>
    <message>
        <source>in %1 the scan is %2 mm along its longest side, as a face or head is</source>
        <translation>in %1 misst die Aufnahme an ihrer längsten Seite %2 mm, wie ein Gesicht oder Kopf</translation>
    </message>
    <message>
        <source>in %1 the scan is %2 mm along its longest side, as a head with shoulders is</source>
        <translation>in %1 misst die Aufnahme an ihrer längsten Seite %2 mm, wie ein Kopf mit Schultern</translation>
    </message>
    <message>
        <source>few scanners use inches, and some use no unit at all</source>
        <translation>wenige Scanner verwenden Zoll, und manche gar keine Einheit</translation>
    </message>
    <message>
        <source>no teeth as dense as enamel or metal are in the CT, so no tissue slides on teeth; mark it with tissue.sliding_vertices where it should</source>
        <translation>im CT sind keine Zähne so dicht wie Schmelz oder Metall, darum gleitet kein Gewebe auf Zähnen; malen Sie im Schritt Region gleitendes Gewebe, wo es das soll</translation>
    </message>
    <message>
        <source>the fixed rim of the region comes within %1 mm of the moving bone, so the face is held back there; a larger region or a photograph that reaches farther would be better</source>
        <translation>der feste Rand der Region kommt dem bewegten Knochen auf %1 mm nahe, so dass das Gesicht dort zurückgehalten wird; eine größere Region oder ein Foto, das weiter reicht, wäre besser</translation>
    </message>
    <message>
        <source>%1 % of the tissue is neither skin, fat nor muscle in the CT and was counted as muscle; check that photograph and CT fit together</source>
        <translation>%1 % des Gewebes sind im CT weder Haut noch Fett noch Muskel und wurden als Muskel gezählt; prüfen Sie, ob Foto und CT zusammenpassen</translation>
    </message>
    <message>
        <source>%1 files repeat a slice exactly and were left out</source>
        <translation>%1 Dateien wiederholen eine Schicht genau und wurden ausgelassen</translation>
    </message>
    <message>
        <source>slice positions scatter by up to %1 mm about even steps; even steps are used</source>
        <translation>die Schichtpositionen weichen bis zu %1 mm von gleichen Abständen ab; gleiche Abstände werden verwendet</translation>
    </message>
    <message>
        <source>the gantry is tilted by %1 degrees; the slices keep their true places, nothing is resampled</source>
        <translation>die Gantry ist um %1 Grad gekippt; die Schichten behalten ihre wahren Orte, nichts wird umgerechnet</translation>
    </message>
    <message>
        <source>%1 names no unit of length: mm are assumed</source>
        <translation>%1 nennt keine Längeneinheit: mm werden angenommen</translation>
    </message>
    <message>
        <source>%1 voxels are not a number and count as air</source>
        <translation>%1 Voxel sind keine Zahl und zählen als Luft</translation>
    </message>
    <message>
        <source>holds no bone at %1 HU</source>
        <translation>enthält bei %1 HU keinen Knochen</translation>
    </message>
    <message>
        <source>holds no skin at %1 HU</source>
        <translation>enthält bei %1 HU keine Haut</translation>
    </message>
    <message>
        <source>choose another HU level, or another CT</source>
        <translation>eine andere HU-Schwelle oder ein anderes CT wählen</translation>
    </message>
    <message>
        <source>holds no readable DICOM file</source>
        <translation>enthält keine lesbare DICOM-Datei</translation>
    </message>
    <message>
        <source>give the folder that holds the DICOM files</source>
        <translation>den Ordner angeben, der die DICOM-Dateien enthält</translation>
    </message>
    <message>
        <source>is a photograph, and no case is open to add it to</source>
        <translation>ist ein Foto, und kein Fall ist offen, zu dem es käme</translation>
    </message>
    <message>
        <source>open a case or import a CT first, then drop the photograph again</source>
        <translation>erst einen Fall öffnen oder ein CT importieren, dann das Foto noch einmal ablegen</translation>
    </message>
    <message>
        <source>painting the skin</source>
        <translation>Haut einfärben</translation>
    </message>
    <message>
        <source>showing the painted skin</source>
        <translation>gefärbte Haut zeigen</translation>
    </message>
    <message>
        <source>writing the photograph</source>
        <translation>Foto schreiben</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>tissue on &quot;%1&quot; is let go within %2 mm of other bone only (tissue.released_mm): it is small</source>
        <translation>das Gewebe an „%1“ wird nur bis %2 mm vor anderem Knochen abgelöst (tissue.released_mm): es ist klein</translation>
    </message>
    <message>
        <source>does not exist or cannot be reached</source>
        <translation>gibt es nicht oder ist nicht zu erreichen</translation>
    </message>
    <message>
        <source>check the name, its rights, and that its disk is connected</source>
        <translation>Namen und Rechte prüfen, und ob der Datenträger verbunden ist</translation>
    </message>
    <message>
        <source>does not exist or cannot be opened</source>
        <translation>gibt es nicht oder lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>check the path and its permissions</source>
        <translation>Pfad und Rechte prüfen</translation>
    </message>
    <message>
        <source>the file does not exist or cannot be reached</source>
        <translation>die Datei gibt es nicht, oder sie ist nicht zu erreichen</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>die Datei lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>check its name and rights</source>
        <translation>Namen und Rechte prüfen</translation>
    </message>
    <message>
        <source>check the file&apos;s name and rights</source>
        <translation>Namen und Rechte der Datei prüfen</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file is larger than 2 GiB</source>
        <translation>die Datei ist größer als 2 GiB</translation>
    </message>
    <message>
        <source>choose another file</source>
        <translation>eine andere Datei wählen</translation>
    </message>
    <message>
        <source>reduce the scan</source>
        <translation>die Aufnahme verkleinern</translation>
    </message>
    <message>
        <source>the file cannot be read to its end</source>
        <translation>die Datei lässt sich nicht bis zum Ende lesen</translation>
    </message>
    <message>
        <source>check the disk and the file&apos;s rights</source>
        <translation>Datenträger und Rechte der Datei prüfen</translation>
    </message>
    <message>
        <source>is one file of a DICOM series</source>
        <translation>ist eine einzelne Datei einer DICOM-Serie</translation>
    </message>
    <message>
        <source>give the folder that holds the series</source>
        <translation>den Ordner angeben, der die Serie enthält</translation>
    </message>
    <message>
        <source>is nothing that Gnathion can open</source>
        <translation>ist nichts, was Gnathion öffnen kann</translation>
    </message>
    <message>
        <source>give a folder with DICOM files, a volume (%1), a photograph (%2) or a case (.json)</source>
        <translation>einen Ordner mit DICOM-Dateien, ein Volumen (%1), ein Foto (%2) oder einen Fall (.json) angeben</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>es ist keine Datei</translation>
    </message>
    <message>
        <source>choose a face scan</source>
        <translation>eine Gesichtsaufnahme wählen</translation>
    </message>
    <message>
        <source>export the scan again, reduced or in another format</source>
        <translation>die Aufnahme noch einmal exportieren, verkleinert oder in einem anderen Format</translation>
    </message>
    <message>
        <source>it cannot be written</source>
        <translation>es lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>it cannot be written (%1); what was there is unchanged</source>
        <translation>es lässt sich nicht schreiben (%1); was dort war, ist unverändert</translation>
    </message>
    <message>
        <source>check free space and rights, or choose another place</source>
        <translation>freien Platz und Rechte prüfen oder einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>it exists already, and nothing is overwritten</source>
        <translation>es gibt ihn schon, und nichts wird überschrieben</translation>
    </message>
    <message>
        <source>name a new folder</source>
        <translation>einen neuen Ordner nennen</translation>
    </message>
    <message>
        <source>no folder can be made here (%1)</source>
        <translation>hier lässt sich kein Ordner anlegen (%1)</translation>
    </message>
    <message>
        <source>choose an existing place that you may write to</source>
        <translation>einen vorhandenen Ort wählen, an den Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>choose a folder that exists and may be written, and see that the disk is not full</source>
        <translation>einen Ordner wählen, den es gibt und in den Sie schreiben dürfen, und prüfen, ob der Datenträger voll ist</translation>
    </message>
</context>
<context>
    <name>display</name>
    <message>
        <source>QT_QPA_PLATFORM is &quot;%1&quot;, but the 3D view needs X11; unset it, or set it to xcb</source>
        <translation>QT_QPA_PLATFORM ist „%1“, aber die 3D-Ansicht braucht X11; entfernen Sie die Variable, oder setzen Sie sie auf xcb</translation>
    </message>
    <message>
        <source>start it within a desktop session (over ssh: ssh -X), or use gnathion-cli, which needs no display</source>
        <translation>starten Sie es in einer Desktop-Sitzung (über ssh: ssh -X), oder verwenden Sie gnathion-cli, das keine Anzeige braucht</translation>
    </message>
    <message>
        <source>no display: DISPLAY is not set; %1</source>
        <translation>keine Anzeige: DISPLAY ist nicht gesetzt; %1</translation>
    </message>
    <message>
        <source>the display &quot;%1&quot; cannot be reached; %2</source>
        <translation>die Anzeige „%1“ ist nicht zu erreichen; %2</translation>
    </message>
    <message>
        <source>the display gives no OpenGL 3.2; update its driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw without one</source>
        <translation>die Anzeige bietet kein OpenGL 3.2; erneuern Sie den Treiber, oder setzen Sie LIBGL_ALWAYS_SOFTWARE=1, um ohne ihn zu zeichnen</translation>
    </message>
</context>
<context>
    <name>gnathion::BackgroundTask</name>
    <message>
        <source>memory</source>
        <translation>der Arbeitsspeicher</translation>
    </message>
    <message>
        <source>there is not enough of it</source>
        <translation>er reicht nicht aus</translation>
    </message>
    <message>
        <source>close other programs, or use a CT or photograph of fewer voxels or vertices</source>
        <translation>schließen Sie andere Programme, oder nehmen Sie ein CT oder Foto mit weniger Voxeln oder Punkten</translation>
    </message>
    <message>
        <source>the program</source>
        <translation>das Programm</translation>
    </message>
    <message>
        <source>a fault of its own (%1)</source>
        <translation>ein eigener Fehler (%1)</translation>
    </message>
    <message>
        <source>nothing was changed; please report it with the files that caused it</source>
        <translation>nichts wurde geändert; bitte melden Sie ihn mit den Dateien, die ihn ausgelöst haben</translation>
    </message>
</context>
<context>
    <name>gnathion::BonePanel</name>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>Bone from %1 HU</source>
        <translation>Knochen ab %1 HU</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>%1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>Remove the %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Blade</source>
        <translation>Sägeblatt</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Saw cut</source>
        <translation>Sägeschnitt</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Comes off: &lt;b&gt;%1&lt;/b&gt;, sawn area %2 cm²</source>
        <translation>Löst sich: &lt;b&gt;%1&lt;/b&gt;, gesägte Fläche %2 cm²</translation>
    </message>
    <message>
        <source>Comes loose and is not moved: %1</source>
        <translation>Wird lose und nicht bewegt: %1</translation>
    </message>
    <message>
        <source>Give a name that no other segment has.</source>
        <translation>Geben Sie einen Namen, den kein anderes Segment hat.</translation>
    </message>
</context>
<context>
    <name>gnathion::CaseController</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Opening the demo case</source>
        <translation>Der Demofall wird geöffnet</translation>
    </message>
    <message>
        <source>Open the demo case</source>
        <translation>Demofall öffnen</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>Import the CT</source>
        <translation>CT importieren</translation>
    </message>
    <message>
        <source>Recovering a case</source>
        <translation>Ein Fall wird wiederhergestellt</translation>
    </message>
    <message>
        <source>The case&apos;s motion is larger than this window can set (%1 mm, %2°) and was cut to that.</source>
        <translation>Die Bewegung des Falls ist größer, als dieses Fenster einstellen kann (%1 mm, %2°), und wurde darauf begrenzt.</translation>
    </message>
    <message>
        <source>Exporting the predicted face</source>
        <translation>Das vorhergesagte Gesicht wird exportiert</translation>
    </message>
    <message>
        <source>Move %1: %2</source>
        <translation>%1 bewegen: %2</translation>
    </message>
</context>
<context>
    <name>gnathion::CaseOpener</name>
    <message>
        <source>Open case</source>
        <translation>Fall öffnen</translation>
    </message>
    <message>
        <source>Case files (*.json)</source>
        <translation>Falldateien (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import a CT: the folder with its DICOM files</source>
        <translation>CT importieren: der Ordner mit seinen DICOM-Dateien</translation>
    </message>
    <message>
        <source>Import a CT: an image volume in Hounsfield units</source>
        <translation>CT importieren: ein Bildvolumen in Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>Image volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz)</source>
        <translation>Bildvolumen (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz)</translation>
    </message>
    <message>
        <source>Add a photograph</source>
        <translation>Foto hinzufügen</translation>
    </message>
    <message>
        <source>Add the photograph</source>
        <translation>Foto hinzufügen</translation>
    </message>
    <message>
        <source>%1 files at once</source>
        <translation>%1 Dateien auf einmal</translation>
    </message>
    <message>
        <source>only one can be opened at a time</source>
        <translation>nur eine kann auf einmal geöffnet werden</translation>
    </message>
    <message>
        <source>drop one file, or the folder that holds the series</source>
        <translation>lassen Sie eine Datei fallen oder den Ordner, der die Serie enthält</translation>
    </message>
    <message>
        <source>Face scans (%1)</source>
        <translation>Gesichtsaufnahmen (%1)</translation>
    </message>
</context>
<context>
    <name>gnathion::CaseSaver</name>
    <message>
        <source>Save the case</source>
        <translation>Fall speichern</translation>
    </message>
    <message>
        <source>Case files (*.json)</source>
        <translation>Falldateien (*.json)</translation>
    </message>
    <message>
        <source>Changes that are not saved</source>
        <translation>Änderungen, die nicht gespeichert sind</translation>
    </message>
    <message>
        <source>The case has changes that are not saved.</source>
        <translation>Der Fall hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>„%1“ hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Discarded changes cannot be brought back.</source>
        <translation>Verworfene Änderungen lassen sich nicht zurückholen.</translation>
    </message>
</context>
<context>
    <name>gnathion::ComparePanel</name>
    <message>
        <source>&lt;b&gt;Refined answer&lt;/b&gt;</source>
        <translation>&lt;b&gt;Verfeinerte Antwort&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Quick answer, not refined yet&lt;/b&gt;: its error is not known</source>
        <translation>&lt;b&gt;Schnelle Antwort, noch nicht verfeinert&lt;/b&gt;: ihr Fehler ist nicht bekannt</translation>
    </message>
    <message>
        <source>Volume gained: %1 cm³ (± %2 cm³)</source>
        <translation>Volumengewinn: %1 cm³ (± %2 cm³)</translation>
    </message>
    <message>
        <source>Volume gained: %1 cm³ (quick answer)</source>
        <translation>Volumengewinn: %1 cm³ (schnelle Antwort)</translation>
    </message>
    <message>
        <source>The signed change is measured when the refined answer is ready.</source>
        <translation>Die Änderung mit Vorzeichen wird gemessen, wenn die verfeinerte Antwort da ist.</translation>
    </message>
    <message>
        <source>No region moves yet.</source>
        <translation>Noch bewegt sich keine Region.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max.</translation>
    </message>
    <message>
        <source>Point at the face to read its change.</source>
        <translation>Auf das Gesicht zeigen, um seine Änderung abzulesen.</translation>
    </message>
    <message>
        <source>%1 of the scan&apos;s origin%2</source>
        <translation>%1 vom Ursprung der Aufnahme%2</translation>
    </message>
    <message>
        <source> (before)</source>
        <translation> (vorher)</translation>
    </message>
    <message>
        <source>does not move</source>
        <translation>bewegt sich nicht</translation>
    </message>
    <message>
        <source>moves %1: %2</source>
        <translation>bewegt sich um %1: %2</translation>
    </message>
    <message>
        <source>signed change %1</source>
        <translation>Änderung %1</translation>
    </message>
    <message>
        <source>quick answer: signed change not measured yet</source>
        <translation>schnelle Antwort: Änderung noch nicht gemessen</translation>
    </message>
    <message>
        <source>Before %1, predicted %2 (%3)%4</source>
        <translation>Vorher %1, vorhergesagt %2 (%3)%4</translation>
    </message>
    <message>
        <source>, quick answer</source>
        <translation>, schnelle Antwort</translation>
    </message>
    <message>
        <source>Straight distance between two points of the face, in mm.</source>
        <translation>Gerader Abstand zwischen zwei Punkten des Gesichts, in mm.</translation>
    </message>
    <message>
        <source>Click the first point on the face.</source>
        <translation>Den ersten Punkt auf dem Gesicht anklicken.</translation>
    </message>
    <message>
        <source>Click the second point on the face.</source>
        <translation>Den zweiten Punkt auf dem Gesicht anklicken.</translation>
    </message>
</context>
<context>
    <name>gnathion::CompareView</name>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Before %1 % · predicted %2 %</source>
        <translation>Vorher %1 % · Vorhersage %2 %</translation>
    </message>
    <message>
        <source>profile in the middle of the face</source>
        <translation>Profil in der Gesichtsmitte</translation>
    </message>
    <message>
        <source>profile %1 of the middle of the face</source>
        <translation>Profil %1 von der Gesichtsmitte</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>Soft-tissue landmarks</source>
        <translation>Weichteil-Landmarken</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Raster</translation>
    </message>
</context>
<context>
    <name>gnathion::CutEditor</name>
    <message>
        <source>Cut the %1</source>
        <translation>Osteotomie: %1</translation>
    </message>
    <message>
        <source>Change the cut of the %1</source>
        <translation>Schnitt ändern: %1</translation>
    </message>
</context>
<context>
    <name>gnathion::Exports</name>
    <message>
        <source>The turning face is %1</source>
        <translation>Das sich drehende Gesicht ist %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export the bones into a new folder</source>
        <translation>Die Knochen in einen neuen Ordner exportieren</translation>
    </message>
    <message>
        <source>Writing the bones as STL</source>
        <translation>Die Knochen werden als STL geschrieben</translation>
    </message>
    <message>
        <source>The segments in their planned places and the remaining bone (STL, mm, LPS) are in %1</source>
        <translation>Die Segmente an ihrem geplanten Ort und der übrige Knochen (STL, mm, LPS) sind in %1</translation>
    </message>
    <message>
        <source>Drawing the turning face</source>
        <translation>Das sich drehende Gesicht wird gezeichnet</translation>
    </message>
</context>
<context>
    <name>gnathion::FaceView</name>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>colours follow when the motion rests</source>
        <translation>die Farben folgen, wenn die Bewegung ruht</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
</context>
<context>
    <name>gnathion::FileDialogs</name>
    <message>
        <source>New folder:</source>
        <translation>Neuer Ordner:</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
</context>
<context>
    <name>gnathion::HistogramView</name>
    <message>
        <source>mm, number of points of the region</source>
        <translation>mm, Zahl der Punkte der Region</translation>
    </message>
</context>
<context>
    <name>gnathion::LipLineTool</name>
    <message>
        <source>Trace the lip line</source>
        <translation>Lippenlinie zeichnen</translation>
    </message>
    <message>
        <source>No lip line was found. %1 Trace it with the mouse.</source>
        <translation>Keine Lippenlinie gefunden. %1 Zeichnen Sie sie mit der Maus.</translation>
    </message>
    <message>
        <source>Propose the lip line</source>
        <translation>Lippenlinie vorschlagen</translation>
    </message>
    <message>
        <source>Look at the proposed lip line. %1</source>
        <translation>Prüfen Sie die vorgeschlagene Lippenlinie. %1</translation>
    </message>
    <message>
        <source>Remove the lip line</source>
        <translation>Lippenlinie entfernen</translation>
    </message>
</context>
<context>
    <name>gnathion::MainWindow</name>
    <message>
        <source>Ph&amp;otograph</source>
        <translation>&amp;Foto</translation>
    </message>
    <message>
        <source>&amp;Bone</source>
        <translation>&amp;Knochen</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>&amp;Region</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleich</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How opaque the face is, 0 to 100 %: less shows the bone below</source>
        <translation>Wie deckend das Gesicht ist, 0 bis 100 %: weniger zeigt den Knochen darunter</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Research use only&lt;/b&gt;</source>
        <translation>&lt;b&gt;Nur für die Forschung&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Not a medical device: not for decisions about a patient&apos;s treatment</source>
        <translation>Kein Medizinprodukt: nicht für Entscheidungen über die Behandlung eines Patienten</translation>
    </message>
    <message>
        <source>Exported</source>
        <translation>Exportiert</translation>
    </message>
    <message>
        <source>&amp;Clear list</source>
        <translation>&amp;Liste leeren</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>The case is %1</source>
        <translation>Der Fall ist %1</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>%1[*] – Gnathion</source>
        <translation>%1[*] – Gnathion</translation>
    </message>
    <message>
        <source>Case without a name</source>
        <translation>Fall ohne Namen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Please note</source>
        <translation>Bitte beachten</translation>
    </message>
    <message>
        <source>Export the predicted face into a new folder</source>
        <translation>Das vorhergesagte Gesicht in einen neuen Ordner exportieren</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures with twice as many pixels each way (*.png)</source>
        <translation>Bilder mit doppelt so vielen Pixeln in jeder Richtung (*.png)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>The picture is %1</source>
        <translation>Das Bild ist %1</translation>
    </message>
    <message>
        <source>Change the tissue model</source>
        <translation>Gewebemodell ändern</translation>
    </message>
    <message>
        <source>About Gnathion</source>
        <translation>Über Gnathion</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Gnathion %1&lt;/h3&gt;&lt;p&gt;Predicts a face after an operation on the jaw, from a CT, a 3D photograph and the planned motion of a bone segment.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Research use only.&lt;/b&gt; Gnathion is not a medical device. Its predictions have not been validated on patients and must not be used for decisions about diagnosis or treatment.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later, without any warranty. It uses Qt, VTK, CGAL, GDCM, OpenCV, Eigen and SuiteSparse.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Gnathion %1&lt;/h3&gt;&lt;p&gt;Sagt ein Gesicht nach einer Kieferoperation vorher, aus einem CT, einem 3D-Foto und der geplanten Bewegung eines Knochensegments.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Nur für die Forschung.&lt;/b&gt; Gnathion ist kein Medizinprodukt. Seine Vorhersagen sind nicht an Patienten validiert und dürfen nicht für Entscheidungen über Diagnose oder Behandlung verwendet werden.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später, ohne jede Gewährleistung. Sie verwendet Qt, VTK, CGAL, GDCM, OpenCV, Eigen und SuiteSparse.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No case is open</source>
        <translation>Kein Fall ist geöffnet</translation>
    </message>
    <message>
        <source>Computing the motion in time</source>
        <translation>Die Bewegung in der Zeit wird berechnet</translation>
    </message>
    <message>
        <source>Playing the damped motion of the linear model</source>
        <translation>Die gedämpfte Bewegung des linearen Modells läuft</translation>
    </message>
    <message>
        <source>%1 ms after the bone moved, played %2 times slower
damped motion, alpha %3/s, beta %4 s, linear model on linear elements</source>
        <translation>%1 ms nach der Bewegung des Knochens, %2-fach verlangsamt
gedämpfte Bewegung, alpha %3/s, beta %4 s, lineares Modell auf linearen Elementen</translation>
    </message>
    <message>
        <source>The predicted face and its report are in %1</source>
        <translation>Das vorhergesagte Gesicht und sein Bericht sind in %1</translation>
    </message>
    <message>
        <source>Face as:</source>
        <translation>Gesicht als:</translation>
    </message>
    <message>
        <source>OBJ with its materials and pictures (*)</source>
        <translation>OBJ mit seinen Materialien und Bildern (*)</translation>
    </message>
    <message>
        <source>GLB, one file with pictures (*)</source>
        <translation>GLB, eine Datei mit Bildern (*)</translation>
    </message>
    <message>
        <source>PLY, one file with coloured vertices (*)</source>
        <translation>PLY, eine Datei mit farbigen Punkten (*)</translation>
    </message>
</context>
<context>
    <name>gnathion::MessageBar</name>
    <message>
        <source>Problem: %1</source>
        <translation>Problem: %1</translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation>Was zu tun ist: %1</translation>
    </message>
</context>
<context>
    <name>gnathion::MotionPanel</name>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>The hinge axis is not known: give it below, with Axis…</source>
        <translation>Die Scharnierachse ist nicht bekannt: geben Sie sie unten ein, mit Achse…</translation>
    </message>
    <message>
        <source>Set the pivot</source>
        <translation>Drehpunkt setzen</translation>
    </message>
    <message>
        <source>About that point the same position takes a shift of more than %1 mm: turn the segment less, or reset its motion first.</source>
        <translation>Um diesen Punkt braucht dieselbe Lage eine Verschiebung von mehr als %1 mm: drehen Sie das Segment weniger, oder setzen Sie erst seine Bewegung zurück.</translation>
    </message>
    <message>
        <source>The condyles are being looked for.</source>
        <translation>Die Kondylen werden gesucht.</translation>
    </message>
    <message>
        <source>Condyles found on the bone, %1 mm apart.</source>
        <translation>Kondylen am Knochen gefunden, %1 mm auseinander.</translation>
    </message>
    <message>
        <source>The left point must lie at least %1 mm to the patient&apos;s left (x) of the right one.</source>
        <translation>Der linke Punkt muss mindestens %1 mm weiter zur linken Seite des Patienten (x) liegen als der rechte.</translation>
    </message>
    <message>
        <source>Axis through two typed points, %1 mm apart.</source>
        <translation>Achse durch zwei eingegebene Punkte, %1 mm auseinander.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>No bone runs into other bone.</source>
        <translation>Kein Knochen dringt in anderen Knochen.</translation>
    </message>
    <message>
        <source>Bones are being prepared.</source>
        <translation>Die Knochen werden vorbereitet.</translation>
    </message>
    <message>
        <source>Find the hinge axis</source>
        <translation>Scharnierachse suchen</translation>
    </message>
    <message>
        <source>Set the hinge axis</source>
        <translation>Scharnierachse setzen</translation>
    </message>
</context>
<context>
    <name>gnathion::PhotographDialog</name>
    <message>
        <source>What &lt;b&gt;%1&lt;/b&gt; does not say about itself:</source>
        <translation>Was &lt;b&gt;%1&lt;/b&gt; nicht über sich sagt:</translation>
    </message>
    <message>
        <source>&amp;Add the photograph</source>
        <translation>Foto &amp;hinzufügen</translation>
    </message>
    <message>
        <source>It cannot be read: %1. What to do: %2.</source>
        <translation>Es kann nicht gelesen werden: %1. Was zu tun ist: %2.</translation>
    </message>
    <message>
        <source>No usual unit would make it as large as a head. %1.</source>
        <translation>In keiner üblichen Einheit wäre es so groß wie ein Kopf. %1.</translation>
    </message>
    <message>
        <source>Likely unit by its size: &lt;b&gt;%1&lt;/b&gt;. %2.</source>
        <translation>Wahrscheinliche Einheit nach seiner Größe: &lt;b&gt;%1&lt;/b&gt;. %2.</translation>
    </message>
</context>
<context>
    <name>gnathion::PhotographsDialog</name>
    <message>
        <source>Nasion</source>
        <translation>Nasion</translation>
    </message>
    <message>
        <source>Nose tip</source>
        <translation>Nasenspitze</translation>
    </message>
    <message>
        <source>Subnasale</source>
        <translation>Subnasale</translation>
    </message>
    <message>
        <source>Outer canthus R</source>
        <translation>Äußerer Lidwinkel R</translation>
    </message>
    <message>
        <source>Inner canthus R</source>
        <translation>Innerer Lidwinkel R</translation>
    </message>
    <message>
        <source>Inner canthus L</source>
        <translation>Innerer Lidwinkel L</translation>
    </message>
    <message>
        <source>Outer canthus L</source>
        <translation>Äußerer Lidwinkel L</translation>
    </message>
    <message>
        <source>Mouth corner R</source>
        <translation>Mundwinkel R</translation>
    </message>
    <message>
        <source>Mouth corner L</source>
        <translation>Mundwinkel L</translation>
    </message>
    <message>
        <source>Pogonion (chin)</source>
        <translation>Pogonion (Kinn)</translation>
    </message>
    <message>
        <source>Tragus (ear) R</source>
        <translation>Tragus (Ohr) R</translation>
    </message>
    <message>
        <source>Tragus (ear) L</source>
        <translation>Tragus (Ohr) L</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Add a photograph of the face</source>
        <translation>Ein Foto des Gesichts hinzufügen</translation>
    </message>
    <message>
        <source>Pictures (*.jpg *.jpeg *.png *.tif *.tiff *.bmp *.webp)</source>
        <translation>Bilder (*.jpg *.jpeg *.png *.tif *.tiff *.bmp *.webp)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Write the painted skin into a new folder</source>
        <translation>Die gefärbte Haut in einen neuen Ordner schreiben</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Add a photograph of the face from the front, then the profiles if there are any.</source>
        <translation>Fügen Sie ein Foto des Gesichts von vorn hinzu, dann die Profile, wenn es sie gibt.</translation>
    </message>
    <message>
        <source>Preview: the photographs on the CT&apos;s skin, not applied yet</source>
        <translation>Vorschau: die Fotos auf der Haut des CT, noch nicht angewandt</translation>
    </message>
    <message>
        <source>The CT&apos;s skin: click the chosen landmark</source>
        <translation>Die Haut des CT: die gewählte Landmarke anklicken</translation>
    </message>
    <message>
        <source>Picked on both: %1 of at least %2.</source>
        <translation>Auf beiden gesetzt: %1 von mindestens %2.</translation>
    </message>
    <message>
        <source>%1 %2. What to do: %3.</source>
        <translation>%1 %2. Was zu tun ist: %3.</translation>
    </message>
    <message>
        <source>Finding the camera…</source>
        <translation>Die Kamera wird gesucht…</translation>
    </message>
    <message>
        <source>Camera found: landmarks off by %1 pixels, %2 mm RMS. The picture&apos;s place on the skin is sure to %3 mm.</source>
        <translation>Kamera gefunden: Landmarken um %1 Pixel, %2 mm RMS daneben. Der Ort des Bildes auf der Haut ist auf %3 mm sicher.</translation>
    </message>
    <message>
        <source>The photographs show %1 of %2 cm² of the head&apos;s skin; %3 cm² beside are made up, the rest has one colour.</source>
        <translation>Die Fotos zeigen %1 von %2 cm² der Haut des Kopfes; %3 cm² daneben sind ergänzt, der Rest hat eine Farbe.</translation>
    </message>
</context>
<context>
    <name>gnathion::PhotographsEditor</name>
    <message>
        <source>Project photographs</source>
        <translation>Fotos projizieren</translation>
    </message>
</context>
<context>
    <name>gnathion::RecentCases</name>
    <message>
        <source>its folder is gone, or its disk is not connected</source>
        <translation>sein Ordner ist fort, oder seine Festplatte ist nicht verbunden</translation>
    </message>
    <message>
        <source>the file was moved or deleted</source>
        <translation>die Datei wurde verschoben oder gelöscht</translation>
    </message>
    <message>
        <source>you may not read it</source>
        <translation>Sie dürfen sie nicht lesen</translation>
    </message>
</context>
<context>
    <name>gnathion::Recovery</name>
    <message>
        <source>Changes cannot be kept for the case of a crash: %1: %2. %3. Save often.</source>
        <translation>Änderungen können für den Fall eines Absturzes nicht gesichert werden: %1: %2. %3. Speichern Sie oft.</translation>
    </message>
    <message>
        <source>A case that was not saved was kept when Gnathion ended unexpectedly. Start Gnathion without a case to recover or to discard it.</source>
        <translation>Ein nicht gespeicherter Fall wurde gesichert, als Gnathion unerwartet endete. Starten Sie Gnathion ohne Fall, um ihn wiederherzustellen oder zu verwerfen.</translation>
    </message>
</context>
<context>
    <name>gnathion::RegionEditor</name>
    <message>
        <source>Erase sliding tissue</source>
        <translation>Gleitendes Gewebe radieren</translation>
    </message>
    <message>
        <source>Paint sliding tissue</source>
        <translation>Gleitendes Gewebe malen</translation>
    </message>
    <message>
        <source>Erase from the region</source>
        <translation>Aus der Region radieren</translation>
    </message>
    <message>
        <source>Paint the region</source>
        <translation>Region malen</translation>
    </message>
    <message>
        <source>Grow the region</source>
        <translation>Region vergrößern</translation>
    </message>
    <message>
        <source>Shrink the region</source>
        <translation>Region verkleinern</translation>
    </message>
    <message>
        <source>Smooth the region</source>
        <translation>Region glätten</translation>
    </message>
    <message>
        <source>Tidy the region</source>
        <translation>Region säubern</translation>
    </message>
    <message>
        <source>Clear the region</source>
        <translation>Region löschen</translation>
    </message>
    <message>
        <source>Suggest the region</source>
        <translation>Region vorschlagen</translation>
    </message>
    <message>
        <source>Mirror the region</source>
        <translation>Region spiegeln</translation>
    </message>
</context>
<context>
    <name>gnathion::RegionPanel</name>
    <message>
        <source>Nothing is painted. Paint the part of the face that may move, or take the suggested region.</source>
        <translation>Nichts ist gemalt. Malen Sie den Teil des Gesichts, der sich bewegen darf, oder nehmen Sie die vorgeschlagene Region.</translation>
    </message>
    <message>
        <source>It is in %1 pieces; the smaller ones are marked. Paint a bridge between them, erase what is too much, or press Tidy up.</source>
        <translation>Sie besteht aus %1 Stücken; die kleineren sind markiert. Malen Sie eine Brücke dazwischen, radieren Sie, was zu viel ist, oder drücken Sie Säubern.</translation>
    </message>
    <message>
        <source>It covers the whole face, so nothing would hold it. Erase where the face should stay.</source>
        <translation>Sie bedeckt das ganze Gesicht, so dass nichts es hielte. Radieren Sie, wo das Gesicht bleiben soll.</translation>
    </message>
    <message numerus="yes">
        <source>Its rim touches itself in %n point(s), which are marked. Press Tidy up.</source>
        <translation>
            <numerusform>Ihr Rand berührt sich in einem Punkt, der markiert ist. Drücken Sie Säubern.</numerusform>
            <numerusform>Ihr Rand berührt sich in %n Punkten, die markiert sind. Drücken Sie Säubern.</numerusform>
        </translation>
    </message>
    <message>
        <source>The region was mirrored across the face&apos;s own midline. The two sides of the face differ by %1 mm on average.</source>
        <translation>Die Region wurde an der Mittellinie des Gesichts gespiegelt. Die beiden Seiten des Gesichts unterscheiden sich im Mittel um %1 mm.</translation>
    </message>
    <message numerus="yes">
        <source>Click from corner to corner, then press Enter. %n point(s) so far.</source>
        <translation>
            <numerusform>Von Mundwinkel zu Mundwinkel klicken, dann die Eingabetaste drücken. Bisher %n Punkt.</numerusform>
            <numerusform>Von Mundwinkel zu Mundwinkel klicken, dann die Eingabetaste drücken. Bisher %n Punkte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut open along the line; contact is not computed.</source>
        <translation>Entlang der Linie aufgeschnitten; Kontakt wird nicht berechnet.</translation>
    </message>
    <message>
        <source>Not cut: closed lips hang together.</source>
        <translation>Nicht aufgeschnitten: geschlossene Lippen hängen zusammen.</translation>
    </message>
    <message>
        <source>%1 cm², %2 triangles</source>
        <translation>%1 cm², %2 Dreiecke</translation>
    </message>
    <message>
        <source>The suggested region is being computed.</source>
        <translation>Die vorgeschlagene Region wird berechnet.</translation>
    </message>
    <message>
        <source>The face cannot follow yet. %1</source>
        <translation>Das Gesicht kann noch nicht folgen. %1</translation>
    </message>
    <message>
        <source>No segment is cut yet. Cut one in the step Bone: the region is then suggested from it; or paint it now.</source>
        <translation>Noch ist kein Segment gesägt. Sägen Sie eines im Schritt Knochen: die Region wird dann daraus vorgeschlagen; oder malen Sie sie jetzt.</translation>
    </message>
    <message>
        <source>The tissue below is being computed.</source>
        <translation>Das Gewebe darunter wird berechnet.</translation>
    </message>
    <message>
        <source>One piece with a rim: the face follows.</source>
        <translation>Ein Stück mit einem Rand: das Gesicht folgt.</translation>
    </message>
    <message>
        <source>The face cannot follow yet: %1. What to do: %2.</source>
        <translation>Das Gesicht kann noch nicht folgen: %1. Was zu tun ist: %2.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>gnathion::RegistrationEditor</name>
    <message>
        <source>The photograph was not fitted</source>
        <translation>Das Foto wurde nicht angepasst</translation>
    </message>
    <message>
        <source>Fit the photograph</source>
        <translation>Foto anpassen</translation>
    </message>
    <message>
        <source>Clear a landmark</source>
        <translation>Landmarke löschen</translation>
    </message>
    <message>
        <source>Pick a landmark</source>
        <translation>Landmarke setzen</translation>
    </message>
</context>
<context>
    <name>gnathion::RegistrationPanel</name>
    <message>
        <source>Nasion</source>
        <translation>Nasion</translation>
    </message>
    <message>
        <source>Nose tip</source>
        <translation>Nasenspitze</translation>
    </message>
    <message>
        <source>Outer canthus R</source>
        <translation>Äußerer Lidwinkel R</translation>
    </message>
    <message>
        <source>Inner canthus R</source>
        <translation>Innerer Lidwinkel R</translation>
    </message>
    <message>
        <source>Inner canthus L</source>
        <translation>Innerer Lidwinkel L</translation>
    </message>
    <message>
        <source>Outer canthus L</source>
        <translation>Äußerer Lidwinkel L</translation>
    </message>
    <message>
        <source>Mouth corner R</source>
        <translation>Mundwinkel R</translation>
    </message>
    <message>
        <source>Mouth corner L</source>
        <translation>Mundwinkel L</translation>
    </message>
    <message>
        <source>Pogonion (chin)</source>
        <translation>Pogonion (Kinn)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Distance to the CT&apos;s skin</source>
        <translation>Abstand zur CT-Haut</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>RMS, mm</source>
        <translation>RMS, mm</translation>
    </message>
    <message>
        <source>Median, mm</source>
        <translation>Median, mm</translation>
    </message>
    <message>
        <source>95th percentile, mm</source>
        <translation>95. Perzentil, mm</translation>
    </message>
    <message>
        <source>Within 2 mm</source>
        <translation>Innerhalb 2 mm</translation>
    </message>
    <message>
        <source>Near the skin</source>
        <translation>Nahe der Haut</translation>
    </message>
    <message>
        <source>Size, mm a unit</source>
        <translation>Größe, mm je Einheit</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Now, mm</source>
        <translation>Jetzt, mm</translation>
    </message>
    <message>
        <source>Use the CT&apos;s skin</source>
        <translation>Haut des CT verwenden</translation>
    </message>
    <message>
        <source>No photograph: the face is the CT&apos;s own skin, without colours.</source>
        <translation>Kein Foto: das Gesicht ist die Haut des CT, ohne Farben.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;, %2 triangles</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;, %2 Dreiecke</translation>
    </message>
    <message>
        <source>%1. What to do: %2.</source>
        <translation>%1. Was zu tun ist: %2.</translation>
    </message>
    <message>
        <source>The fit came to rest after %1 steps; nothing speaks against it. Look whether left is left, then accept it.</source>
        <translation>Die Anpassung kam nach %1 Schritten zur Ruhe; nichts spricht gegen sie. Prüfen Sie, ob links links ist, und übernehmen Sie sie.</translation>
    </message>
    <message>
        <source>A proposal: the plan keeps its place until you accept it.</source>
        <translation>Ein Vorschlag: der Plan behält seine Lage, bis Sie ihn übernehmen.</translation>
    </message>
    <message>
        <source>The photograph does not lie on the CT&apos;s skin. What to do: fit it.</source>
        <translation>Das Foto liegt nicht auf der Haut des CT. Was zu tun ist: anpassen.</translation>
    </message>
    <message>
        <source>Picked on both: %1 of at least 3.</source>
        <translation>Auf beiden gesetzt: %1 von mindestens 3.</translation>
    </message>
    <message>
        <source>Picked on both: %1. A surface fit may lower the distances and yet part the landmarks: watch both.</source>
        <translation>Auf beiden gesetzt: %1. Eine Anpassung der Oberflächen kann die Abstände verringern und doch die Landmarken trennen: achten Sie auf beides.</translation>
    </message>
    <message>
        <source>Photograph where it is proposed, not accepted yet</source>
        <translation>Foto, wo es vorgeschlagen ist, noch nicht übernommen</translation>
    </message>
    <message>
        <source>Photograph where the plan has it</source>
        <translation>Foto, wo der Plan es hat</translation>
    </message>
    <message>
        <source>Skin of the CT</source>
        <translation>Haut des CT</translation>
    </message>
    <message>
        <source>colours: mm above (red) and below (blue) the CT&apos;s skin</source>
        <translation>Farben: mm über (rot) und unter (blau) der Haut des CT</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>&amp;Accept all the same</source>
        <translation>Trotzdem über&amp;nehmen</translation>
    </message>
    <message>
        <source>&amp;Accept</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>The whole photograph decides.</source>
        <translation>Das ganze Foto entscheidet.</translation>
    </message>
    <message>
        <source>The stable region is being proposed.</source>
        <translation>Die stabile Region wird vorgeschlagen.</translation>
    </message>
    <message>
        <source>Painted as stable: %1.</source>
        <translation>Als stabil gemalt: %1.</translation>
    </message>
    <message>
        <source>Proposed as stable: forehead, brows and bridge of the nose, %1.</source>
        <translation>Als stabil vorgeschlagen: Stirn, Brauen und Nasenrücken, %1.</translation>
    </message>
</context>
<context>
    <name>gnathion::SeriesDialog</name>
    <message>
        <source>can be imported</source>
        <translation>kann importiert werden</translation>
    </message>
    <message>
        <source>no: not a CT</source>
        <translation>nein: kein CT</translation>
    </message>
    <message>
        <source>no: too few slices for a volume</source>
        <translation>nein: zu wenige Schichten für ein Volumen</translation>
    </message>
    <message>
        <source>Series in &lt;b&gt;%1&lt;/b&gt;</source>
        <translation>Serien in &lt;b&gt;%1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>None of these can be imported. Choose a folder with a CT of the head.</source>
        <translation>Keine davon kann importiert werden. Wählen Sie einen Ordner mit einem CT des Kopfes.</translation>
    </message>
    <message>
        <source>Choose the CT of the head to import.</source>
        <translation>Wählen Sie das CT des Kopfes zum Importieren.</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(verborgen)</translation>
    </message>
</context>
<context>
    <name>gnathion::SliceView</name>
    <message>
        <source>no CT here</source>
        <translation>hier kein CT</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 HU</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>W %1
L %2 HU</source>
        <translation>B %1
Z %2 HU</translation>
    </message>
</context>
<context>
    <name>gnathion::StableRegionEditor</name>
    <message>
        <source>Take the proposed stable region</source>
        <translation>Vorgeschlagene stabile Region nehmen</translation>
    </message>
    <message>
        <source>Erase from the stable region</source>
        <translation>Aus der stabilen Region radieren</translation>
    </message>
    <message>
        <source>Paint the stable region</source>
        <translation>Stabile Region malen</translation>
    </message>
</context>
<context>
    <name>gnathion::TurntableDialog</name>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>Export the turning face</source>
        <translation>Das sich drehende Gesicht exportieren</translation>
    </message>
    <message>
        <source>Films (*.avi)</source>
        <translation>Filme (*.avi)</translation>
    </message>
    <message>
        <source>Say where to.</source>
        <translation>Sagen Sie, wohin.</translation>
    </message>
    <message>
        <source>That exists already: choose another name.</source>
        <translation>Das gibt es schon: wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The folder does not exist.</source>
        <translation>Den Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>One turn in %1 s, %2 pictures a second.</source>
        <translation>Eine Drehung in %1 s, %2 Bilder je Sekunde.</translation>
    </message>
</context>
<context>
    <name>gnathion::TurntableExport</name>
    <message>
        <source>it exists already</source>
        <translation>es gibt es schon</translation>
    </message>
    <message>
        <source>choose another name; nothing was overwritten</source>
        <translation>wählen Sie einen anderen Namen; nichts wurde überschrieben</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
</context>
<context>
    <name>gnathion::ViewGrid</name>
    <message>
        <source>bone that stays</source>
        <translation>bleibender Knochen</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>skin before</source>
        <translation>Haut vorher</translation>
    </message>
    <message>
        <source>skin predicted</source>
        <translation>Haut vorhergesagt</translation>
    </message>
    <message>
        <source>Segment “%1”</source>
        <translation>Segment „%1“</translation>
    </message>
    <message>
        <source>Bone that stays</source>
        <translation>Bleibender Knochen</translation>
    </message>
    <message>
        <source>Skin before</source>
        <translation>Haut vorher</translation>
    </message>
    <message>
        <source>Skin predicted</source>
        <translation>Haut vorhergesagt</translation>
    </message>
    <message>
        <source>By hand: level %1, width %2 HU</source>
        <translation>Von Hand: Zentrum %1, Breite %2 HU</translation>
    </message>
</context>
<context>
    <name>gnathion::WelcomePage</name>
    <message>
        <source>A DICOM &amp;folder…</source>
        <translation>DICOM-&amp;Ordner…</translation>
    </message>
    <message>
        <source>An image &amp;volume…</source>
        <translation>Bild&amp;volumen…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Case without a name</source>
        <translation>Fall ohne Namen</translation>
    </message>
    <message>
        <source>was not saved yet</source>
        <translation>war noch nicht gespeichert</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>aus %1</translation>
    </message>
    <message>
        <source>d MMMM yyyy, hh:mm</source>
        <translation>dd.MM.yyyy, hh:mm</translation>
    </message>
    <message>
        <source>%1
kept %2, %3</source>
        <translation>%1
gesichert am %2, %3</translation>
    </message>
</context>
<context>
    <name>language</name>
    <message>
        <source>The window speaks the chosen language when Gnathion is started again.</source>
        <translation>Das Fenster spricht die gewählte Sprache, wenn Gnathion neu gestartet wird.</translation>
    </message>
</context>
<context>
    <name>motion</name>
    <message>
        <source>%1 mm forward</source>
        <translation>%1 mm nach vorn</translation>
    </message>
    <message>
        <source>%1 mm back</source>
        <translation>%1 mm nach hinten</translation>
    </message>
    <message>
        <source>%1 mm up</source>
        <translation>%1 mm nach oben</translation>
    </message>
    <message>
        <source>%1 mm down</source>
        <translation>%1 mm nach unten</translation>
    </message>
    <message>
        <source>%1 mm to the left</source>
        <translation>%1 mm nach links</translation>
    </message>
    <message>
        <source>%1 mm to the right</source>
        <translation>%1 mm nach rechts</translation>
    </message>
    <message>
        <source>%1° chin up</source>
        <translation>%1° Kinn nach oben</translation>
    </message>
    <message>
        <source>%1° chin down</source>
        <translation>%1° Kinn nach unten</translation>
    </message>
    <message>
        <source>%1° left side up</source>
        <translation>%1° linke Seite nach oben</translation>
    </message>
    <message>
        <source>%1° right side up</source>
        <translation>%1° rechte Seite nach oben</translation>
    </message>
    <message>
        <source>%1° chin to left</source>
        <translation>%1° Kinn nach links</translation>
    </message>
    <message>
        <source>%1° chin to right</source>
        <translation>%1° Kinn nach rechts</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>beidseits</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>in the middle</source>
        <translation>in der Mitte</translation>
    </message>
    <message>
        <source>%1 runs %2 mm into the fixed bone (%3)</source>
        <translation>%1 dringt %2 mm in den festen Knochen (%3)</translation>
    </message>
    <message>
        <source>%1 and %2 run %3 mm into each other (%4)</source>
        <translation>%1 und %2 dringen %3 mm ineinander (%4)</translation>
    </message>
    <message>
        <source>not moved</source>
        <translation>nicht bewegt</translation>
    </message>
</context>
<context>
    <name>place</name>
    <message>
        <source>%1 mm left</source>
        <translation>%1 mm nach links</translation>
    </message>
    <message>
        <source>%1 mm right</source>
        <translation>%1 mm nach rechts</translation>
    </message>
    <message>
        <source>%1 mm back</source>
        <translation>%1 mm nach hinten</translation>
    </message>
    <message>
        <source>%1 mm forward</source>
        <translation>%1 mm nach vorn</translation>
    </message>
    <message>
        <source>%1 mm up</source>
        <translation>%1 mm nach oben</translation>
    </message>
    <message>
        <source>%1 mm down</source>
        <translation>%1 mm nach unten</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
</TS>
