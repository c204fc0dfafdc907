(What MELDAS has otherwise than FANUC.)
(SOURCE M700V and M70V programming manual: 12.2, 14.4 page 508, 15.4 page 554, 13 on variables)
(CONTROL meldas mazatrol-iso)

(CASE MB-291 G53 leaves the length offset out of its own move only)
(SHEET [tools.1])
(SHEET length = 100.0)
%
O1
G90 G43 H1 G0 Z200.
G53 Z0
#100=#5083
Z50.
M30
%
(EXPECT MOVE 2 Z0)
(EXPECT #100 = 100)
(EXPECT MOVE 3 Z150)

(CASE MB-291 G91 G53 moves by its values)
(START X = 30)
%
O1
G91 G53 X-10. Z5.
M30
%
(EXPECT MOVE 1 X20 Z5)
(EXPECT NO WARNING PRB314)

(CASE MB-336 P of M98 is a program, whatever its digits)
%
O1
M98 P21000
M30
O1000
#500=#500+1
M99
%
(EXPECT ALARM 232 AT 3)

(CASE MB-336 with all of them)
%
O1
M98 P21000 L2
M30
O21000
#500=#500+1
M99
%
(EXPECT #500 = 2)

(CASE MB-278 P of G31 is a mask of signals, parameters or not)
(SIGNAL X12.5)
%
O1
G31 P255 X20. F100.
#100=#5061
M30
%
(EXPECT #100 = 12.5)

(CASE MB-278 a mask of no signal)
%
O1
G31 P0 X20. F100.
M30
%
(EXPECT ALARM 35 AT 3)

(CASE MB-278 a mask of more signals than there are)
%
O1
G31 P256 X20. F100.
M30
%
(EXPECT ALARM 35 AT 3)

(CASE MB-283 G31.n listens to its own signals, at its own feed)
(SOURCE M700V programming manual 15.3)
(SHEET [parameters])
(SHEET 1175 = 1)
(SHEET 1177 = 6)
(SHEET 1178 = 60)
(SHEET [probe])
(SHEET input = 2)
(SHEET ball_diameter = 2.0)
(SHEET [[part]])
(SHEET shape = "block")
(SHEET at = [50.0, 0.0, -110.0])
%
O1
G31.1 X19.5 F100.
#100=#5061
G1 X0 F500.
G31.2 X25.
#101=#5061
M30
%
(EXPECT #100 = 19.5)
(EXPECT #101 = 19)

(CASE MB-283 G31.1 to G31.3 are skip moves)
(SIGNAL X3)
(SIGNAL X7)
%
O1
G31.1 X20. F100.
#100=#5061
G31.2 X20. F50.
#101=#5061
M30
%
(EXPECT #100 = 3)
(EXPECT #101 = 7)

(CASE MB-075 AND and OR join comparisons)
%
O1
#1=1
IF [[#1 EQ 1] AND [#2 EQ #0]] GOTO 10
#100=1
N10 IF [[#1 EQ 2] OR [#1 GT 0]] GOTO 20
#101=1
N20 M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = VACANT)

(CASE MB-095 common variables of the larger sets are there and vacant at first)
%
O1
#100=#450
#101=#900000
#450=4.5
#907399=7
#102=#450
#103=#[907000+399]
M30
%
(EXPECT #100 = VACANT)
(EXPECT #101 = VACANT)
(EXPECT #102 = 4.5)
(EXPECT #103 = 7)

(CASE MB-095 #100100 and on are those of the first part system)
%
O1
#100100=8
#101=#100
#150=2
#102=#100150
M30
%
(EXPECT #101 = 8)
(EXPECT #102 = 2)

(CASE MB-095 one beyond them is no variable)
%
O1
#907400=1
M30
%
(EXPECT ALARM 241 AT 3)

(CASE MB-072 #100010 shows the parameter that #100000 names)
(PARAMETER 8008 = 12.5)
%
O1
#100000=8008
#100=#100010
M30
%
(EXPECT #100 = 12.5)

(CASE MB-072 of an axis)
(PARAMETER 2037.Z = -250)
(PARAMETER 2037.X = 7)
%
O1
#100000=2037
#100002=3
#100=#100010
#100002=1
#101=#100010
M30
%
(EXPECT #100 = -250)
(EXPECT #101 = 7)

(CASE MB-278 only the signals of the mask end the move)
(START Z = 200)
(SHEET [probe])
(SHEET input = 2)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
G31 P1 Z150. F100.
#100=#5063
G31 P5 Z140. F100.
#101=#5063
G31 P2 Z100. F100.
#102=#5063
G0 Z150.
G31 P255 Z100. F100.
#103=#5063
G0 Z150.
G31 Z100. F100.
#104=#5063
M30
%
(EXPECT #100 = 150)
(EXPECT #101 = 140)
(EXPECT #102 = 123)
(EXPECT #103 = 123)
(EXPECT #104 = 123)

(CASE MB-190 codes before G65 take effect before the call)
(SOURCE main programs of a mould shop that run so)
%
O1
G55 G91 G65 P9500 X1.
M30
O9500
#100=#4012
#101=#4003
#102=#24
M99
%
(EXPECT #100 = 55)
(EXPECT #101 = 91)
(EXPECT #102 = 1)

(CASE MB-197 behind it a code is no argument)
%
O1
G65 P9500 G55
M30
O9500
M99
%
(EXPECT ALARM 275 AT 3)

(CASE G37 and G37.1 take R, D and F in the place of parameters 6251, 6254 and 6241)
(CONTROL meldas)
(SOURCE M700V programming manual 15.1)
(SHEET [tools.1])
(SHEET length = 100.0)
(START Z = 300)
(PARAMETER 6241 = 50)
(PARAMETER 6251 = 2)
(PARAMETER 6254 = 0.1)
(SIGNAL Z139.5)
(SIGNAL Z139.5)
%
O1
G43 H1 F700.
G90 G37.1 Z40. R5. D1. F80.
#100=#2001+#2201
#101=#4109
G0 Z60.
G37 Z40. R7. D1.
M30
%
(EXPECT #100 = 99.5)
(EXPECT #101 = 700)
(EXPECT MOVE 2 Z145)
(EXPECT MOVE 3 Z139.5 F80)
(EXPECT MOVE 4 Z160)
(EXPECT MOVE 5 Z147)

(CASE a Mazak measures with G37, too)
(CONTROL mazatrol-iso)
(SHEET [tools.1])
(SHEET length = 100.0)
(START Z = 300)
(PARAMETER 6241 = 50)
(PARAMETER 6254 = 10)
(SIGNAL Z139.5)
%
O1
G43 H1
G90 G37 Z40. R5. D1. F80.
#100=#2001+#2201
M30
%
(EXPECT #100 = 99.5)
(EXPECT MOVE 2 Z145)

(CASE G37.1 whose signal comes outside of D)
(CONTROL meldas)
(SHEET [tools.1])
(SHEET length = 100.0)
(START Z = 300)
(PARAMETER 6241 = 50)
(PARAMETER 6254 = 10)
(SIGNAL Z139.5)
%
O1
G43 H1
G90 G37.1 Z40. R5. D0.4
M30
%
(EXPECT ALARM 607 AT 11)

(CASE MB-305 P of a helix counts whole turns beside the angle between its ends, of one pitch)
%
O1
G17 G90 G0 X10. Y0 Z0
G3 X10. Y0 I-10. J0 Z-5. P2 F1000
G3 X0 Y10. I-10. J0 Z-10. P1
G2 X10. Y0 I0 J-10. Z-11. P0
M30
%
(EXPECT MOVE 2 G3 X10 Y0 Z-2.5)
(EXPECT MOVE 3 G3 X10 Y0 Z-5)
(EXPECT MOVE 4 G3 X10 Y0 Z-9)
(EXPECT MOVE 5 G3 X0 Y10 Z-10)
(EXPECT MOVE 6 G2 X10 Y0 Z-11)

(CASE MB-305 clockwise from X10 to Y10 are three quarters of a turn)
%
O1
G17 G90 G0 X10. Y0 Z0
G2 X0 Y10. I-10. J0 Z-7. P1 F1000
M30
%
(EXPECT MOVE 2 G2 X10 Y0 Z-4)
(EXPECT MOVE 3 G2 X0 Y10 Z-7)

(CASE MB-305 it has a range)
%
O1
G17 G90 G0 X10. Y0 Z0
G3 X10. Y0 I-10. J0 Z-5. P10000 F1000
M30
%
(EXPECT ALARM 35 AT 4)

(CASE MB-305 P without a third axis, or beside R, counts nothing)
%
O1
G17 G90 G0 X10. Y0 Z0
G3 X10. Y0 I-10. J0 P3 F1000
G3 X0 Y10. R10. Z-1. P3
M30
%
(EXPECT MOVE 2 G3 X10 Y0 Z0)
(EXPECT MOVE 3 G3 X0 Y10 Z-1)

(CASE MB-339 ASIN gives -90 to 90)
(SOURCE M700V programming manual 13.5)
%
O1
#100=ASIN[-0.5]
#101=ASIN[1]
#102=ASIN[-1]
M30
%
(EXPECT #100 = -30)
(EXPECT #101 = 90)
(EXPECT #102 = -90)

(CASE G76 and G87 step aside by I and J)
(SOURCE M700V programming manual, fixed cycles)
%
O1
G90 G54 G00 X0 Y0 Z50.
G98 G87 X10. Y5. Z-5. R-20. I1. J-0.5 F100.
G76 X20. Y5. Z-6. R2. I1. F100.
G80
M30
%
(EXPECT MOVE 2 X10 Y5 Z50)
(EXPECT MOVE 3 X11 Y4.5 Z50)
(EXPECT MOVE 4 X11 Y4.5 Z-20)
(EXPECT MOVE 5 X10 Y5 Z-20)
(EXPECT MOVE 6 X10 Y5 Z-5)
(EXPECT MOVE 7 X11 Y4.5 Z-5)
(EXPECT MOVE 8 X11 Y4.5 Z50)
(EXPECT MOVE 9 X10 Y5 Z50)
(EXPECT MOVE 12 X20 Y5 Z-6)
(EXPECT MOVE 13 X21 Y5 Z-6)

(CASE G84 with ,R1: F is the lead of the tap, until ,R0)
(SOURCE M700V programming manual, fixed cycles)
%
O1
G90 G54 G94 G00 X0 Y0 Z50.
S500 M3
G99 G84 X1. Y1. Z-5. R2. F1.25 ,R1
X2.
X3. ,R0
G80
M30
%
(EXPECT MOVE 4 X1 Y1 Z-5 F625)
(EXPECT MOVE 5 X1 Y1 Z2 F625)
(EXPECT MOVE 8 X2 Y1 Z-5 F625)
(EXPECT MOVE 12 X3 Y1 Z-5 F1.25)

(CASE G51: a whole P counts millionths, one with a point is the factor)
(SOURCE M700V programming manual, scaling)
%
O1
G90 G54 G0 X0 Y0
G51 X0 Y0 P2000000
X10.
#100=#5021
G51 X0 Y0 P0.5
X10.
#101=#5021
#1=0.25
G51 X0 Y0 P#1
X10.
#102=#5021
G50
M30
%
(EXPECT #100 = 20)
(EXPECT #101 = 5)
(EXPECT #102 = 2.5)

(CASE axes that the centre does not name are not scaled)
(SOURCE M700V programming manual, scaling)
%
O1
G90 G54 G0 X0 Y0
G51 X0 P500000
X10. Y10.
#100=#5021
#101=#5022
G51 X0 Y0 I0.5 J2.
X10. Y10.
#102=#5021
#103=#5022
G50
M30
%
(EXPECT #100 = 5)
(EXPECT #101 = 10)
(EXPECT #102 = 5)
(EXPECT #103 = 20)
(EXPECT NO WARNING PRB328)

(CASE MB-291 G53 goes as G00 or G01 is in force)
%
O1
G01 X10. F100.
G53 X50.
G00
G53 X60.
M30
%
(EXPECT MOVE 2 G1 X50 F100)
(EXPECT MOVE 3 G0 X60)

(CASE G52 is of the work system in force alone, and adds under G91)
(SOURCE M700V programming manual 14.11, page 531)
(SHEET [work_offsets.G54])
(SHEET X = 100.0)
(SHEET [work_offsets.G55])
(SHEET X = 200.0)
%
O1
G90 G54 G52 X10.
G55 G0 X0
#100=#5021
G91 G54 G52 X10.
G90 X0
#101=#5021
#102=#5001
G55 G52 X-5. Y3.
X1. Y0
#103=#5021
#104=#5022
G54 X0 Y0
#105=#5021
#106=#5022
G54 G52 X0
X0
#107=#5021
G55 X0
#108=#5021
M30
%
(EXPECT #100 = 200)
(EXPECT #101 = 120)
(EXPECT #102 = 0)
(EXPECT #103 = 196)
(EXPECT #104 = 3)
(EXPECT #105 = 120)
(EXPECT #106 = 0)
(EXPECT #107 = 100)
(EXPECT #108 = 195)

(CASE G92 shifts all work systems alike and leaves each its G52, G92.1 ends both)
(SHEET [work_offsets.G54])
(SHEET X = 100.0)
(SHEET [work_offsets.G55])
(SHEET X = 200.0)
%
O1
G90 G55 G52 X5.
G54 G52 X10.
G0 X0
G92 X-3.
X0
#100=#5021
G55 X0
#101=#5021
G92.1 X0
X0
#102=#5021
G54 X0
#103=#5021
M30
%
(EXPECT #100 = 113)
(EXPECT #101 = 208)
(EXPECT #102 = 200)
(EXPECT #103 = 100)

(CASE G10 L2 without P sets the work system in force, and that of its own block)
(SOURCE M700V programming manual, page 237, 9 to 11)
%
O1
G90 G55 G0 X100. Y50.
G10 L2 X-100. Y-50.
#500=#5201
#501=#5241
G0 X0
G10 G56 L2 X5.
#502=#5261
#503=#5241
M30
%
(EXPECT #500 = 0)
(EXPECT #501 = -100)
(EXPECT MOVE 2 X-100)
(EXPECT #502 = 5)
(EXPECT #503 = -100)

(CASE with axes G10 without L sets a work offset, by P or that in force)
%
O1
G10 P1 X5.
#500=#5221
G56 G10 X7.
#501=#5261
G54.1 P2
G10 Y3.
#502=#7022
G10 L20 P1 Y4.
#503=#7002
M30
%
(EXPECT #500 = 5)
(EXPECT #501 = 7)
(EXPECT #502 = 3)
(EXPECT #503 = 4)
