(What a Brother has otherwise than a FANUC.)
(SOURCE Brother C00 NC programming manual eCOM3NCPR, chapter 6: tool replacement canned cycle G100 and M06,)
(SOURCE M98Hxxxx; published post processors: G4 P0.6 and #3006=...)
(CONTROL brother)

(CASE G100: Z up to its reference point, the other axes, then Z with the new length)
(SHEET [tools.2])
(SHEET length = 100.0)
(PARAMETER 1240.Z = 50)
(START X = 10)
(START Z = -200)
%
O1
G90 G54 G00
G100 T2 X30. Y40. G43 Z5. H2 S3000 M03
#100=#5003
#101=#5083
#102=#4120
M30
%
(EXPECT MOVE 1 G0 X10 Y0 Z50)
(EXPECT MOVE 2 G0 X30 Y40 Z50)
(EXPECT MOVE 3 G0 X30 Y40 Z105)
(EXPECT MOVES 3)
(EXPECT #100 = 5)
(EXPECT #101 = 100)
(EXPECT #102 = 2)

(CASE M06 is the same cycle, here without a place to go to)
(START Z = -200)
%
O1
T3
M06
G00 X1.
M30
%
(EXPECT MOVE 1 G0 X0 Y0 Z0)
(EXPECT MOVE 2 G0 X1 Z0)
(EXPECT MOVES 2)

(CASE the tool is another one only when Z is up)
(SHEET [probe])
(SHEET ball_diameter = 6.0)
(SHEET length = 100.0)
(SHEET tool = 2)
(SHEET [tools.2])
(SHEET length = 100.0)
(SHEET [[part]])
(SHEET shape = "block")
(SHEET at = [0.0, 0.0, -300.0])
(START X = 40)
%
O1
G90 G54
G100 T2 X0. Y0. G43 Z-280. H2
G31 Z-320. F100.
#100=#5063-#5083
M30
%
(EXPECT #100 = -297 WITHIN 0.01)

(CASE G4 P with a point is seconds, without one milliseconds)
%
O1
#3001=0
G4 P0.6
#100=#3001
G4 P400
#101=#3001
M30
%
(EXPECT #100 = 600)
(EXPECT #101 = 1000)

(CASE M98 H is a block of the same program)
%
O1
M98 H20
#101=#100+1
M30
N20 #100=5
M99
%
(EXPECT #100 = 5)
(EXPECT #101 = 6)

(CASE M98 with P and H is refused: which of them counts is not known)
%
O1
M98 P2 H20
M30
O2
N20 M99
%
(EXPECT ALARM 76 AT 3)

(CASE #3006 takes its text without a number)
%
O1
#3006=(CHECK THE VICE)
M30
%
(EXPECT STOP "CHECK THE VICE")

(CASE #3006 of the others does not)
(CONTROL fanuc-16i haas)
%
O1
#3006=(CHECK THE VICE)
M30
%
(EXPECT ALARM FORMAT AT 4)

(CASE codes that are passed over)
%
O1
G36 X1. Y1. I10. J30. K6
G37 X1. Y1. I10. J30. K6
G77 X10. Z-5. R2. I1. S500
G181 X1. Z-5. R2. F100.
G00 X1.
M30
%
(EXPECT MOVES 1)
(EXPECT WARNING PRB304 AT 3)

(CASE automatic workpiece measurement ends the run)
%
O1
G121 X1. Y1. Z1. R5. Q3.
M30
%
(EXPECT ALARM 10 AT 3)

(CASE DPRNT takes up to nine places on either side of the point)
%
O1
#1=-12.34567
#2=1.5
#3=0.5
POPEN
DPRNT[A#1[54]B#3[09]C#2[91]]
DPRNT[#1[20]]
PCLOS
M30
%
(EXPECT OUTPUT "A-   12.3457B .500000000C         1.5\n-12\n")
