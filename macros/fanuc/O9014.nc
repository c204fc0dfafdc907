%
O9014 (G130 DISTANCE OF TWO POINTS, AND THE ANGLE OF THEIR LINE)
(CALL  G130 A_ B_ C_ S_ T_ D_ I_ W_)
(A B C  TWO ROWS OF ONE BUFFER, 12, OR ONE ROW EACH OF TWO  #1 #2 #3)
(S  DISTANCE  0 DIRECT  1 IN X-Y  2 IN Y-Z  3 IN Z-X        #19)
(T  ANGLE TO  0 NONE  1 X-Y  2 Y-Z  3 Z-X                   #20)
(D  ROW 1 TO 5 OF BUFFER D                                  #7)
(I  NUMBER TO PRINT, 0 TO 99, THE ROW IF NOT GIVEN          #4)
(W  NOT 0 MEANS NO PRINT                                    #23)
(BUFFER D  X #110.., Y #125.., Z #140.., DISTANCE #155.., ANGLE #170..)
(X Y Z FROM THE FIRST POINT TO THE SECOND)
IF [#7 EQ #0] THEN #7= 1
IF [#7 NE ROUND[#7]] GOTO 92
IF [#7 LT 1] GOTO 92
IF [#7 GT 5] GOTO 92
IF [#4 EQ #0] THEN #4= #7
IF [#4 NE ROUND[#4]] GOTO 92
IF [#4 LT 0] GOTO 92
IF [#4 GT 99] GOTO 92
IF [#19 EQ #0] THEN #19= 0
IF [#19 NE ROUND[#19]] GOTO 92
IF [#19 LT 0] GOTO 92
IF [#19 GT 3] GOTO 92
IF [#20 EQ #0] THEN #20= 0
IF [#20 NE ROUND[#20]] GOTO 92
IF [#20 LT 0] GOTO 92
IF [#20 GT 3] GOTO 92
(POINTS TO #24 #25 #26 AND #27 #28 #29)
#8= 0 (POINTS FOUND)
#9= 1 (LETTER A B C)
WHILE [#9 LE 3] DO1
#10= #[#9]
IF [#10 EQ #0] GOTO 3
IF [#10 NE ROUND[#10]] GOTO 92
IF [#10 LT 1] GOTO 92
IF [#10 GT 99] GOTO 92
#12= 89+5*#9 (COLUMN X OF THE BUFFER, BEFORE ROW 1)
#13= 5 (ITS ROWS)
IF [#9 EQ 1] THEN #12= 159
IF [#9 EQ 1] THEN #13= 9
#15= 10
WHILE [#15 GE 1] DO2
#14= FIX[[#10+.5]/#15]
#10= #10-#14*#15
IF [#14 GT 0] GOTO 1
IF [#15 EQ 1] GOTO 92
GOTO 2
N1 IF [#14 GT #13] GOTO 92
IF [#8 EQ 2] GOTO 92
IF [#[#12+#14] EQ #0] GOTO 93
IF [#[#12+#14+15] EQ #0] GOTO 93
IF [#[#12+#14+30] EQ #0] GOTO 93
#[24+3*#8]= #[#12+#14]
#[25+3*#8]= #[#12+#14+15]
#[26+3*#8]= #[#12+#14+30]
#8= #8+1
N2 #15= #15/10
END2
N3 #9= #9+1
END1
IF [#8 LT 2] GOTO 91
#24= #27-#24
#25= #28-#25
#26= #29-#26
#30= #24*#24
#31= #25*#25
#32= #26*#26
#16= SQRT[#30+#31+#32]
#17= #16 (THE DISTANCE ASKED FOR)
IF [#19 EQ 1] THEN #17= SQRT[#30+#31]
IF [#19 EQ 2] THEN #17= SQRT[#31+#32]
IF [#19 EQ 3] THEN #17= SQRT[#32+#30]
#18= #0
IF [#20 EQ 0] GOTO 4
IF [#16 LT .001] GOTO 94
IF [#20 EQ 1] THEN #18= ATAN[ABS[#26]]/[SQRT[#30+#31]]
IF [#20 EQ 2] THEN #18= ATAN[ABS[#24]]/[SQRT[#31+#32]]
IF [#20 EQ 3] THEN #18= ATAN[ABS[#25]]/[SQRT[#32+#30]]
N4 #[109+#7]= #24
#[124+#7]= #25
#[139+#7]= #26
#[154+#7]= #17
#[169+#7]= #18
IF [ABS[#23] GT 0] GOTO 9
#24= ABS[#24]
#25= ABS[#25]
#26= ABS[#26]
POPEN
DPRNT[+*****-----*G130*SOKUTEI*-----*****+]
DPRNT[+**********************************+]
DPRNT[+*2*POINT*INTERVAL*NO.#4[20]**********+]
DPRNT[+**********************************+]
DPRNT[+*3D.*INC.*DATA********************+]
DPRNT[+*X#24[43]*Y#25[43]*Z#26[43]*+]
DPRNT[+*DISTANCE*DATA********************+]
DPRNT[+*DIRECT#16[43]******************+]
IF [#20 EQ 0] GOTO 8
DPRNT[+*ANGLE*DATA***********************+]
IF [#20 EQ 2] GOTO 5
IF [#20 EQ 3] GOTO 6
DPRNT[+*X-Y*PLANE*#18[33]***************+]
GOTO 8
N5 DPRNT[+*Y-Z*PLANE*#18[33]***************+]
GOTO 8
N6 DPRNT[+*Z-X*PLANE*#18[33]***************+]
N8 DPRNT[+**********************************+]
DPRNT[+*********-----*END*-----**********+]
PCLOS
N9 M99
N91 #3000= 160 (DATA EMPTY)
N92 #3000= 182 (DATA OVER)
N93 #3000= 160 (ROW EMPTY)
N94 #3000= 162 (POINTS TOO CLOSE)
%
