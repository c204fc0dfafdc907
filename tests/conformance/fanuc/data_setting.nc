(G10: MB-255 to MB-264.)

(CASE MB-255 work offsets by L2: P0 external, P1 to P6 G54 to G59; what is not named stays)
%
O1
G10 L2 P0 Z1.
G10 L2 P1 X2. Y3.
G10 L2 P1 X4.
G10 L2 P6 X5.
#100=#5203
#101=#5221
#102=#5222
#103=#5321
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 4)
(EXPECT #102 = 3)
(EXPECT #103 = 5)

(CASE MB-256 additional ones by L20)
%
O1
G10 L20 P1 X1.
G10 L20 P48 Y2.
G10 L20 P300 Z3.
#100=#7001
#101=#7942
#102=#19983
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 2)
(EXPECT #102 = 3)

(CASE MB-257 memory C: L10 to L13)
%
O1
G10 L10 P3 R1.
G10 L11 P3 R2.
G10 L12 P3 R3.
G10 L13 P3 R4.
#100=#11003
#101=#10003
#102=#13003
#103=#12003
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 2)
(EXPECT #102 = 3)
(EXPECT #103 = 4)

(CASE MB-257 memory B: L10 and L11)
(SETTING offset_memory = "B")
%
O1
G10 L10 P3 R1.
G10 L11 P3 R2.
#100=#2203
#101=#2003
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 2)

(CASE MB-257 it has no L12)
(CONTROL fanuc-30i)
(SETTING offset_memory = "B")
%
O1
G10 L12 P3 R1.
M30
%
(EXPECT ALARM 1144 AT 5)

(CASE MB-257 memory A: L11)
(SETTING offset_memory = "A")
%
O1
G10 L11 P3 R2.
#100=#2003
M30
%
(EXPECT #100 = 2)

(CASE MB-257 it has no L10)
(CONTROL fanuc-30i)
(SETTING offset_memory = "A")
%
O1
G10 L10 P3 R1.
M30
%
(EXPECT ALARM 1144 AT 5)

(CASE MB-258 no L and L1 mean L11)
%
O1
G10 P3 R2.
#100=#10003
G10 L1 P3 R3.
#101=#10003
M30
%
(EXPECT #100 = 2)
(EXPECT #101 = 3)

(CASE MB-259 G91 adds)
%
O1
G90 G10 L10 P3 R1.
G91 G10 L10 P3 R.5
G10 L2 P1 X2.
G10 L2 P1 X2.
G90
#100=#11003
#101=#5221
M30
%
(EXPECT #100 = 1.5)
(EXPECT #101 = 4)

(CASE MB-260 parameters between G10 L50 and G11)
%
O1
#1=-123.456
POPEN
DPRNT[#1[44]]
G10 L50
N6001 R00000010
G11
DPRNT[#1[44]]
PCLOS
M30
%
(EXPECT OUTPUT "- 123.4560\n-123.4560\n")

(CASE MB-260 newer controls write L52)
%
O1
G10 L52
N6001 R00000010
N10002 R-3
N1320 P1 R20.
G11
#100=1
M30
%
(EXPECT #100 = 1)
(EXPECT WARNING PRB505 AT 6)

(CASE MB-260 tool life groups are passed over with a warning)
%
O1
G10 L3
P1 L10
T1
G11
#100=1
M30
%
(EXPECT #100 = 1)
(EXPECT WARNING PRB304 AT 3)

(CASE MB-262 without a point R and axis values count least increments)
%
O1
G10 L10 P3 R1500
G10 L2 P1 X2500
#100=#11003
#101=#5221
M30
%
(EXPECT #100 = 1.5)
(EXPECT #101 = 2.5)

(CASE MB-263 no such P)
%
O1
G10 L2 P7 X1.
M30
%
(EXPECT ALARM 31 AT 3)

(CASE MB-263 a value out of range)
(CONTROL fanuc-16i)
%
O1
G10 L10 P1 R99999.
M30
%
(EXPECT ALARM 32 AT 4)

(CASE a work offset that the program writes is there, whatever the sheet has)
(SHEET [work_offsets.G54])
(SHEET X = 1.0)
%
O1
#5241=7.
G90 G55 G00 X0.
#100=#5021
#7001=9.
G54.1 P1 X0.
#101=#5021
G10 L2 P3 X11.
G56 X0.
#102=#5021
M30
%
(EXPECT #100 = 7)
(EXPECT #101 = 9)
(EXPECT #102 = 11)

(CASE without a sheet G10 makes the others no less)
%
O1
G10 L2 P1 X10.
G90 G55 G00 X0.
#100=#5021
M30
%
(EXPECT #100 = 0)

(CASE a tool offset stays below its limit, by whatever way it is entered)
(SOURCE alarm list of FANUC 16i, alarm 032: by G10 or by system variables)
(CONTROL fanuc-16i)
%
O1
#2201=999.999
#100=#2201
#2201=1000.
M30
%
(EXPECT #100 = 999.999)
(EXPECT ALARM 32 AT 7)

(CASE below zero, too)
(CONTROL fanuc-16i)
%
O1
#11002=-1000.
M30
%
(EXPECT ALARM 32 AT 4)

(CASE an axis does not move beside G10 with a tool offset, and is told)
(SOURCE alarm list of FANUC 30i, alarm 0031: an address that is not of the data)
(CONTROL fanuc-16i)
%
O1
G90 G10 L10 P5 R1. G01 X5. F100
M30
%
(EXPECT ALARM 31 AT 5)

(CASE those of a work offset are its data)
(CONTROL fanuc-16i)
%
O1
G90 G10 L2 P1 X5. F100 M08
#100=#5221
M30
%
(EXPECT #100 = 5)

(CASE MELDAS has a number of its own for each: no such data)
(SOURCE M700V programming manual, page 237, program errors)
(CONTROL meldas)
%
O1
G10 L99 P1 R5.
M30
%
(EXPECT ALARM 172 AT 5)

(CASE no such offset)
(CONTROL meldas)
%
O1
G10 L10 P9999 R5.
M30
%
(EXPECT ALARM 170 AT 4)

(CASE no such work system)
(CONTROL meldas)
%
O1
G10 L2 P9 X5.
M30
%
(EXPECT ALARM 173 AT 4)
