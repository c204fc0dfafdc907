(G31 and what bears on it: MB-265 to MB-284.)

(CASE MB-265 the signal ends the move and the next block runs)
(SIGNAL X12.345)
%
O1
G31 X50. F100.
#100=#5061
#101=#5001
M30
%
(EXPECT MOVE 1 G31 X12.345 F100)
(EXPECT #100 = 12.345)
(EXPECT #101 = 12.345)

(CASE MB-266 group 01 stays as it is)
(SIGNAL X5.)
%
O1
G00
G31 X50. F100.
#100=#4001
X20.
M30
%
(EXPECT #100 = 0)
(EXPECT MOVE 2 G0 X20)

(CASE MB-267 F of an earlier block counts, F of this block stays)
(SIGNAL NONE)
(SIGNAL NONE)
%
O1
F300.
G31 X1.
G31 X2. F50.
G01 X3.
M30
%
(EXPECT MOVE 1 G31 F300)
(EXPECT MOVE 2 G31 F50)
(EXPECT MOVE 3 G1 F50)

(CASE MB-268 feed override and dry run leave it alone)
(SETTING feed_override = 50.0)
(SIGNAL NONE)
%
O1
G01 X1. F100.
G31 X2.
G02 X4. I1.
M30
%
(EXPECT MOVE 1 G1 F50)
(EXPECT MOVE 2 G31 F100)
(EXPECT MOVE 3 G2 F50)

(CASE MB-268 the dry run too)
(SETTING dry_run = 2000.0)
(SIGNAL NONE)
%
O1
G01 X1. F100.
G31 X2.
M30
%
(EXPECT MOVE 1 G1 F2000)
(EXPECT MOVE 2 G31 F100)

(CASE MB-268 unless parameter 6200.7 is 1)
(CONTROL fanuc-16i fanuc-30i fanuc-0i)
(PARAMETER 6200.7 = 1)
(SETTING feed_override = 50.0)
(SIGNAL NONE)
%
O1
G31 X2. F100.
M30
%
(EXPECT MOVE 1 G31 F50)

(CASE MB-268 then the dry run acts on it, too)
(PARAMETER 6200.7 = 1)
(SETTING dry_run = 2000.0)
(SIGNAL NONE)
%
O1
G31 X2. F100.
M30
%
(EXPECT MOVE 1 G31 F2000)

(CASE MB-128 bit 1 of #3004 takes the override away, G63 and tapping as well)
(SETTING feed_override = 50.0)
%
O1
#3004=2
G01 X1. F100.
#3004=0
X2.
G63 X3.
G64 X4.
M30
%
(EXPECT MOVE 1 F100)
(EXPECT MOVE 2 F50)
(EXPECT MOVE 3 F100)
(EXPECT MOVE 4 F50)

(CASE MB-165 block skip leaves a skip move out)
(SETTING block_skip = [2])
(SIGNAL X5.)
%
O1
/2 G31 X50. F100.
/3 G31 X40. F100.
M30
%
(EXPECT MOVES 1)
(EXPECT MOVE 1 G31 X5)

(CASE MB-270 without a signal it ends at its end: no alarm)
(SIGNAL NONE)
%
O1
G31 X50. F100.
#100=#5061
M30
%
(EXPECT #100 = 50)
(EXPECT WARNING PRB301 AT 4)

(CASE MB-271 G91 counts from where the axes stand)
(SIGNAL X3.)
(SIGNAL X9.)
%
O1
G91 G31 X50. F100.
G31 X50.
G00 X1.
M30
%
(EXPECT MOVE 1 G31 X3)
(EXPECT MOVE 2 G31 X9)
(EXPECT MOVE 3 G0 X10)

(CASE MB-273 not in cutter compensation)
(CONTROL fanuc-16i fanuc-30i fanuc-0i)
(SIGNAL X3.)
%
O1
G41 D1 G01 X1. F100.
G31 X50.
M30
%
(EXPECT ALARM 35 AT 6)

(CASE MB-273 G42 neither)
(CONTROL fanuc-16i fanuc-30i)
(SIGNAL X3.)
%
O1
G42 D1 G01 X1. F100.
G31 X50.
M30
%
(EXPECT ALARM 35 AT 6)

(CASE MB-273 P608 on the MELDAS)
(CONTROL meldas)
(SIGNAL X3.)
%
O1
G41 D1 G01 X1. F100.
G31 X50.
M30
%
(EXPECT ALARM 608 AT 6)

(CASE MB-273 behind G40 it may)
(SIGNAL X30.)
%
O1
G41 D1 G01 X1. F100.
G40 X10.
G31 X50.
M30
%
(EXPECT MOVE 3 G31 X30)

(CASE MB-277 a signal that is on already: the block ends at once)
(CONTROL fanuc-16i fanuc-30i meldas)
(START X = 6)
(SIGNAL X5.)
%
O1
G31 X50. F100.
#100=#5061
#101=#5001
G91 G00 X1.
M30
%
(EXPECT MOVE 1 G31 X6)
(EXPECT #100 = 6)
(EXPECT #101 = 6)
(EXPECT MOVE 2 G0 X7)
(EXPECT WARNING PRB302 AT 6)

(CASE MB-276 the tool length is still in #5063, the tip is #5063 minus #5083)
(SHEET [tools.50])
(SHEET length = 100.0)
(SIGNAL Z90.)
(START Z = 200)
%
O1
G90 G54 G43 G31 Z[-20.] H50 F100.
#100=#5063
#101=#5083
#102=#5063-#5083
M30
%
(EXPECT #100 = 90)
(EXPECT #101 = 100)
(EXPECT #102 = -10)

(CASE MB-302 a full circle has a centre and no end)
%
O1
G02 I-5. F100.
#100=#5001
M30
%
(EXPECT MOVES 1)
(EXPECT MOVE 1 G2 X0 Y0)
(EXPECT #100 = 0)

(CASE MB-278 P1 to P4 listen to the signals of parameters 6202 to 6205 alone)
(PARAMETER 6202.0 = 1)
(PARAMETER 6203.1 = 1)
(PARAMETER 6204 = 3)
(START Z = 200)
(SHEET [probe])
(SHEET input = 2)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
G31 P1 Z150. F100.
#100=#5063
G31 P2 Z100. F100.
#101=#5063
G00 Z150.
G31 P3 Z100. F100.
#102=#5063
G00 Z150.
G31 P4 Z100. F100.
M30
%
(EXPECT #100 = 150)
(EXPECT #101 = 123)
(EXPECT #102 = 123)
(EXPECT ALARM 370 AT 19)

(CASE MB-284 G31 without an axis leaves the result of the skip move before it)
(SIGNAL X7.)
%
O1
G31 X10. F100.
G31
#100=#5061
M30
%
(EXPECT MOVE 1 G31 X7 F100)
(EXPECT #100 = 7)
(EXPECT NO WARNING PRB301)
