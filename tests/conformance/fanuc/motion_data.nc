(SOURCE B-64154EN/01 p. 53 and B-63980EN/01 pp. 99 and 100; expected times are closed forms)

(CASE an axis that lags by 2.92 mm when its command stands: in-position width and NCI)
(SHEET [machine.axes.X])
(SHEET servo_gain = 1.0)
(SHEET acceleration = 1000.0)
(SHEET rapid = 6000.0)
#3001=0
G0X100.
#100=#3001
G4X3.
G10L50
N1826P1R5
G11
#3001=0
G0X0
#101=#3001
G4X3.
G10L52
N1601R00100000
G11
#3001=0
G0X100.
#102=#3001
G4X3.
#3001=0
G61G1X0F6000
#103=#3001
M30
(EXPECT #100 = 1440 WITHIN 1)
(EXPECT #101 = 1482 WITHIN 1)
(EXPECT #102 = 1100 WITHIN 1)
(EXPECT #103 = 1100 WITHIN 1)

(CASE acceleration behind the interpolation: two blocks of 50 mm at 50 mm/s and the time constant, linear 0.2 s, bell 0.2 sqrt 2)
G10L52
N1622R200
N1610R00000001
G11
#3001=0
G1X50.F3000
X100.
#100=#3001
G10L52
N1610R00000010
G11
#3001=0
X50.
X0
#101=#3001
G10L52
N1622R0
G11
#3001=0
X50.
X100.
#102=#3001
M30
(EXPECT #100 = 2200 WITHIN 1)
(EXPECT #101 = 2283 WITHIN 1)
(EXPECT #102 = 2025 WITHIN 1)

(CASE speed of corners by the difference of an axis' feed, 1783: a square of 100 mm at 3000 mm/min, 2000 mm/s2)
G10L52
N1783R400
G11
G5.1Q1
#3001=0
G1X100.F3000
Y100.
X0
Y0
#101=#3001
G5.1Q0
G10L52
N1783R1000
G11
G5.1Q1
#3001=0
G1X100.F3000
Y100.
X0
Y0
#102=#3001
M30
(EXPECT #101 = 8081 WITHIN 1)
(EXPECT #102 = 8058 WITHIN 1)

(CASE feed of arcs by their acceleration, 1730 to 1732: 1000 at radius 5 are 2000 at 20 and 100 at 0.05, which 1732 makes 300)
G10L52
N1730R1000
N1731R5.
N1732R300
G11
G0X20.
#3001=0
G3I-20.F3000
#100=#3001
G5.1Q1
#3001=0
G3I-20.F3000
#101=#3001
G0X1.
#3001=0
G3I-0.05F3000
#102=#3001
M30
(2 pi R / v + v / a, with a = 2000 / sqrt 2)
(EXPECT #100 = 2549 WITHIN 1)
(EXPECT #101 = 3794 WITHIN 1)
(EXPECT #102 = 66 WITHIN 1)

(CASE straightness whose points fall)
G10L52
N3620P1R5
N3621P1R1
N3622P1R9
N3624P1R50.
N5711R1
N5721R3
N5731R1
N5732R5
N5733R4
N5734R9
G11
M30
(EXPECT ALARM 5046 AT 12)

(CASE MB-020 F without a point counts 1 mm a minute)
(SOURCE parameter 1403.0 of the 16i parameter manual, B-63190EN)
%
O1
G1 X10. F100
X20. F100.
M30
%
(EXPECT MOVE 1 X10 F100)
(EXPECT MOVE 2 X20 F100)

(CASE MB-020 and 0.01 inch a minute)
%
O1
G20 G1 X1. F100
X2. F10.
M30
%
(EXPECT MOVE 1 X25.4 F25.4)
(EXPECT MOVE 2 X50.8 F254)

(CASE MB-020 finer with parameter 1403.0)
(PARAMETER 1403.0 = 1)
%
O1
G1 X10. F100
G20 G1 X1. F100
#100=#4109
M30
%
(EXPECT MOVE 1 X10 F0.1)
(EXPECT #100 = 0.001)

(CASE MB-020 with the pocket calculator's point it counts the unit)
(PARAMETER 3401.0 = 1)
%
O1
G20 G1 X1 F100
#100=#4109
M30
%
(EXPECT #100 = 100)

(CASE G68 cutter compensation across the turned plane)
(SOURCE 0i operator's manual B-63503EN: the plane of rotation and that of compensation must be the same)
%
O1
G17 G68 X0 Y0 R90.
G18
G1 G41 D1 X10. Z0 F100.
M30
%
(EXPECT ALARM 144 AT 6)

(CASE G51 no scaling begins in cutter compensation)
(SHEET [tools.1])
(SHEET radius = 2.0)
%
O1
G1 G41 D1 X5. F100.
X10.
G51 X0 Y0 P2000
M30
%
(EXPECT ALARM 141 AT 7)

(CASE the centres of G68 and G51 are coordinates under G91, too)
(SOURCE FANUC 30i B-63944EN, coordinate system rotation and scaling: absolute command)
%
O1
G90 G54 G00 X10. Y10.
G91 G68 X5. Y5. R90.
G90 X6. Y5.
#100=#5021
#101=#5022
G69
X10. Y10.
G91 G51 X1. Y2. P2000
G90 X3. Y3.
#102=#5021
#103=#5022
M30
%
(EXPECT #100 = 5)
(EXPECT #101 = 6)
(EXPECT #102 = 5)
(EXPECT #103 = 4)
